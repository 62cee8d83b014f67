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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_HESSIAN_ENERGY_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_HESSIAN_ENERGY_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/higher_order/hessian_energy.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/bilaplacian.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/curved_hessian.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE Eigen::SparseMatrix<double> hessian_energy(const Indexed_triangles& mesh,
                                                           const Triangle_metrics& metrics, Hessian_kind kind,
                                                           bool parallel)
{
  return kind == Hessian_kind::BILAPLACIAN ? bilaplacian(mesh, metrics, parallel)
                                           : curved_hessian(mesh, metrics, kind, parallel);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_HESSIAN_ENERGY_IMPL_H
