// Copyright (c) 2026  The Gradient_domain_processing authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Gradient_domain_processing authors

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_MODIFIED_DIRICHLET_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_MODIFIED_DIRICHLET_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>
#include <CGAL/Gradient_domain_processing/internal/metric/Triangle_metrics.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// <N_i, N_j> S_ij, with unit normals N at the vertices: the Dirichlet energy of the field u N in space, which
// discretizes that of |grad u|^2 + (k1^2 + k2^2) u^2 (Hildebrandt et al. 2012, equations 11 and 12). Semidefinite, S on
// a plane.
Eigen::SparseMatrix<double> modified_dirichlet(const Indexed_triangles& mesh, const Triangle_metrics& metrics,
                                               const std::vector<Vec3>& normals, bool parallel);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/higher_order/modified_dirichlet_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_MODIFIED_DIRICHLET_H
