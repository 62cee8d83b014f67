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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_HESSIAN_ENERGY_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_HESSIAN_ENERGY_H

#include <CGAL/Gradient_domain_processing/Hessian_kind.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>
#include <CGAL/Gradient_domain_processing/internal/metric/Triangle_metrics.h>

#include <Eigen/SparseCore>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The matrix Q of the energy's term of second order: gamma Q is added to alpha M + beta S. Over all vertices, stored as
// a whole, in 1 / squared lengths of the arrays.
Eigen::SparseMatrix<double> hessian_energy(const Indexed_triangles& mesh, const Triangle_metrics& metrics,
                                           Hessian_kind kind, bool parallel);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/higher_order/hessian_energy_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_HESSIAN_ENERGY_H
