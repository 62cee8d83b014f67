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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_SHELL_HESSIAN_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_SHELL_HESSIAN_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// What a shell resists: bending at its edges, stretching of edges, stretching of triangles. The Hessian has the units
// of bending / length^2, length / length and area.
struct Shell_stiffness
{
  double bending = 1;
  double length = 1;
  double area = 1;
};

Eigen::SparseMatrix<double> shell_hessian(const Indexed_triangles& mesh, const Shell_stiffness& stiffness,
                                          bool parallel);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/higher_order/shell_hessian_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_SHELL_HESSIAN_H
