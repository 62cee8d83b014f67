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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_TURN_TO_CHOLESKY_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_TURN_TO_CHOLESKY_H

#include <CGAL/Gradient_domain_processing/Default_sparse_linear_solver.h>
#include <CGAL/Gradient_domain_processing/visitor.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Any_linear_solver.h>

#include <memory>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Takes Cholesky in place of an iterative solver that did not converge. False where that cannot be hoped for.
inline bool turn_to_cholesky(int number_of_degrees_of_freedom, Progress& progress,
                             std::unique_ptr<Any_linear_solver>& solver)
{
  constexpr int largest = 1000000; // where there are more, memory may be why no Cholesky was asked for
  if(!solver->is_iterative() || number_of_degrees_of_freedom > largest)
    return false;
  solver = any_linear_solver(Default_sparse_linear_solver());
  progress.notice("the iterative solver did not converge; the system is solved by Cholesky factorization");
  return true;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_TURN_TO_CHOLESKY_H
