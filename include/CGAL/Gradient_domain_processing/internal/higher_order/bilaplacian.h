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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_BILAPLACIAN_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_BILAPLACIAN_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>
#include <CGAL/Gradient_domain_processing/internal/metric/Triangle_metrics.h>

#include <Eigen/SparseCore>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// A third of the area of the triangles around every vertex.
std::vector<double> lumped_masses(const Indexed_triangles& mesh, const Triangle_metrics& metrics, bool parallel);

// S M^-1 S with the lumped mass M: the squared Laplacian. One element a vertex: its row of S, squared, over its mass.
// Borders have the condition of S, no slope across them, which bends isolines; see curved_hessian().
Eigen::SparseMatrix<double> bilaplacian(const Indexed_triangles& mesh, const Triangle_metrics& metrics, bool parallel);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/higher_order/bilaplacian_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_BILAPLACIAN_H
