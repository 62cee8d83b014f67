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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_CHOLESKY_FACTOR_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_CHOLESKY_FACTOR_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Sequential_blas_scope.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <new>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// A positive definite matrix of any pattern, of which the lower triangle is read, and its factor.
class Cholesky_factor
{
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
  Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>, Eigen::Lower> m_solver;
  typedef Sequential_blas_scope Thread_scope;
#else
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower> m_solver;
  struct Thread_scope {};
#endif

public:
  Cholesky_factor()
  {
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
    m_solver.cholmod().print = 0;
#endif
  }

  Error_code factorize(const Eigen::SparseMatrix<double>& matrix)
  {
    const Thread_scope scope{};
    (void)scope;
    try { m_solver.compute(matrix); }
    catch(const std::bad_alloc&) { return error_cannot_solve_linear_system; }
    return m_solver.info() == Eigen::Success ? ok : error_cannot_solve_linear_system;
  }

  Eigen::MatrixXd solve(const Eigen::MatrixXd& right)
  {
    const Thread_scope scope{};
    (void)scope;
    return m_solver.solve(right);
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_CHOLESKY_FACTOR_H
