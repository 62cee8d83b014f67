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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_SHIFTED_FACTOR_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_SHIFTED_FACTOR_H

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

#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
// Gives access to the diagonal of the factor. CHOLMOD solves four right-hand sides at a time.
class Ldlt : public Eigen::CholmodSimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower>
{
public:
  typedef Sequential_blas_scope Thread_scope;

  Ldlt()
  {
    cholmod().print = 0;
    // the order of the degrees of freedom, which may be one of nested dissection, or another if that fills in less
    cholmod().nmethods = 2;
    cholmod().method[0].ordering = CHOLMOD_NATURAL;
    cholmod().method[1].ordering = CHOLMOD_AMD;
  }

  double pivot(int i) const
  {
    return static_cast<const double*>(m_cholmodFactor->x)[static_cast<const int*>(m_cholmodFactor->p)[i]];
  }
};
#else
class Ldlt : public Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower>
{
public:
  struct Thread_scope {};

  double pivot(int i) const { return vectorD()[i]; }
};
#endif

// A - sigma B with both symmetric, B positive definite, factorized as L D L^T. By Sylvester's law of inertia the signs
// of D count the eigenvalues of the pair below sigma.
class Shifted_factor
{
  Ldlt m_solver;
  int m_size = 0;
  bool m_is_analyzed = false;

public:
  Error_code factorize(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b, double sigma)
  {
    const Ldlt::Thread_scope scope{};
    (void)scope;
    const Eigen::SparseMatrix<double> shifted = a - sigma * b;
    m_size = int(a.rows());
    try
    {
      if(!m_is_analyzed)
        m_solver.analyzePattern(shifted);
      m_is_analyzed = true;
      m_solver.factorize(shifted);
    }
    catch(const std::bad_alloc&) { return error_cannot_solve_linear_system; }
    return m_solver.info() == Eigen::Success ? ok : error_cannot_solve_linear_system;
  }

  int number_of_eigenvalues_below() const
  {
    int count = 0;
    for(int i = 0; i < m_size; ++i)
      if(m_solver.pivot(i) < 0)
        ++count;
    return count;
  }

  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const
  {
    const Ldlt::Thread_scope scope{};
    (void)scope;
    return m_solver.solve(right);
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_SHIFTED_FACTOR_H
