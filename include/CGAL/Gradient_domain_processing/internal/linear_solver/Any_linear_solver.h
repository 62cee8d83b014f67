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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ANY_LINEAR_SOLVER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ANY_LINEAR_SOLVER_H

#include <CGAL/Gradient_domain_processing/internal/linear_solver/Linear_solver.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Solver_task.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <functional>
#include <memory>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// What a linear system asks of its solver, whichever that is: all above it is compiled once for all solvers. See
// Linear_solver.
class Any_linear_solver
{
public:
  virtual ~Any_linear_solver() {}

  // Before anything else of the following: what it is going to be asked for.
  virtual void prepare(const Solver_task&) {}

  virtual bool reads_lower_triangle() const = 0;
  virtual bool is_iterative() const = 0;
  virtual bool needs_order() const = 0;

  virtual Error_code analyze(const Eigen::SparseMatrix<double>& matrix) = 0;
  virtual bool has_factor() const = 0;
  virtual Error_code factorize(const Eigen::SparseMatrix<double>& matrix, const std::function<bool()>& go_on) = 0;
  virtual Error_code solve(const Eigen::MatrixXd& right, Eigen::MatrixXd& solution,
                           const std::function<bool()>& go_on) = 0;
};

template <class SolverTraits>
class Any_linear_solver_of : public Any_linear_solver
{
  typedef Linear_solver<SolverTraits> Solver;

  Solver m_solver;

public:
  explicit Any_linear_solver_of(const SolverTraits& traits) : m_solver(traits) {}

  bool reads_lower_triangle() const override { return Solver::reads_lower_triangle; }
  bool is_iterative() const override { return Solver::is_iterative; }
  bool needs_order() const override { return Solver::needs_order; }
  Error_code analyze(const Eigen::SparseMatrix<double>& matrix) override { return m_solver.analyze(matrix); }
  bool has_factor() const override { return m_solver.has_factor(); }
  Error_code factorize(const Eigen::SparseMatrix<double>& matrix, const std::function<bool()>& go_on) override
  {
    return m_solver.factorize(matrix, go_on);
  }
  Error_code solve(const Eigen::MatrixXd& right, Eigen::MatrixXd& solution, const std::function<bool()>& go_on) override
  {
    return m_solver.solve(right, solution, go_on);
  }
};

template <class SolverTraits>
std::unique_ptr<Any_linear_solver> any_linear_solver(const SolverTraits& traits)
{
  return std::make_unique<Any_linear_solver_of<SolverTraits> >(traits);
}

// The default where there is no CHOLMOD.
typedef Eigen_solver_traits<
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int> > >
  Eigen_cholesky_traits;

#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
extern template std::unique_ptr<Any_linear_solver> any_linear_solver(const Default_sparse_linear_solver&);
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
extern template std::unique_ptr<Any_linear_solver> any_linear_solver(const Eigen_cholesky_traits&);
#endif
#endif

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ANY_LINEAR_SOLVER_H
