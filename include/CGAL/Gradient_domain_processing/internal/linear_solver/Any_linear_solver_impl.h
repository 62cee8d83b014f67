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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ANY_LINEAR_SOLVER_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ANY_LINEAR_SOLVER_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/linear_solver/Any_linear_solver.h>
#include <CGAL/Gradient_domain_processing/Conjugate_gradient_solver_traits.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
template std::unique_ptr<Any_linear_solver> any_linear_solver(const Default_sparse_linear_solver&);
template std::unique_ptr<Any_linear_solver> any_linear_solver(
  const Conjugate_gradient_solver_traits<Parallel_if_available_tag>&);
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
template std::unique_ptr<Any_linear_solver> any_linear_solver(const Eigen_cholesky_traits&);
#endif
#endif

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ANY_LINEAR_SOLVER_IMPL_H
