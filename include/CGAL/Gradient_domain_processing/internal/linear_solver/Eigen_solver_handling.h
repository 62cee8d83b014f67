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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_EIGEN_SOLVER_HANDLING_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_EIGEN_SOLVER_HANDLING_H

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// How a solver of Eigen is handled of which no more is known than whether the lower triangle of the matrix is all it
// reads.
template <class EigenSolver, bool lower>
struct Usual_handling
{
  static constexpr bool reads_lower_triangle = lower;

  // Lives while the solver works.
  struct Work_scope
  {
    Work_scope(EigenSolver&, bool /* merges_small_fronts */) {}
  };

  // Whether the last work failed and info() does not tell.
  static bool has_failed(EigenSolver&) { return false; }

  // Gives back what a solver needs while it works only, and would keep.
  static void release_workspace(EigenSolver&) {}
};

template <class EigenSolver>
struct Eigen_solver_handling : Usual_handling<EigenSolver, false> {};

template <class Matrix, class Ordering>
struct Eigen_solver_handling<Eigen::SimplicialLLT<Matrix, Eigen::Lower, Ordering> >
  : Usual_handling<Eigen::SimplicialLLT<Matrix, Eigen::Lower, Ordering>, true> {};
template <class Matrix, class Ordering>
struct Eigen_solver_handling<Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Ordering> >
  : Usual_handling<Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Ordering>, true> {};
template <class Matrix, class Preconditioner>
struct Eigen_solver_handling<Eigen::ConjugateGradient<Matrix, Eigen::Lower, Preconditioner> >
  : Usual_handling<Eigen::ConjugateGradient<Matrix, Eigen::Lower, Preconditioner>, true> {};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_EIGEN_SOLVER_HANDLING_H
