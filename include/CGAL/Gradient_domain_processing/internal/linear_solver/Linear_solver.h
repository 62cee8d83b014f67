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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_LINEAR_SOLVER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_LINEAR_SOLVER_H

#include <CGAL/Gradient_domain_processing/Default_sparse_linear_solver.h>
#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Cholmod.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Eigen_solver_handling.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Solver_claim.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <functional>
#include <memory>
#include <new>
#include <type_traits>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The one place that talks to linear solvers. Copies of a solver's traits may share one factor: has_factor() tells
// whether that of this object is still there, and factorize() analyzes again where it has to. Can be moved, not copied.
//
// This is for any model of SparseLinearAlgebraWithFactorTraits_d: the matrix is handed over entry by entry, and the
// channels are solved one after the other. Whether copies share anything is not known; that they do is assumed.
template <class SolverTraits>
class Linear_solver
{
  typedef typename SolverTraits::Matrix Matrix;
  typedef typename SolverTraits::Vector Vector;
  typedef typename SolverTraits::NT NT;

  SolverTraits m_traits;
  std::unique_ptr<Matrix> m_matrix; // factor() may keep a pointer to it
  NT m_denominator = NT(1);         // solutions are multiples of it
  Solver_claim m_claim{all_of_the_type()};
  bool m_is_factorized = false;

public:
  static constexpr bool reads_lower_triangle = false; // of the matrix, and nothing else
  static constexpr bool is_iterative = false;
  static constexpr bool needs_order = true; // that of nested dissection, for it may be a factorization

  explicit Linear_solver(const SolverTraits& traits) : m_traits(traits) {}

  // Before the analysis, where the graph is one of degree three.
  void merge_small_fronts() {}

  Error_code analyze(const Eigen::SparseMatrix<double>&) { return ok; }

  bool has_factor() const { return m_is_factorized && m_claim.is_last(); }

  // The matrix need not stay.
  Error_code factorize(const Eigen::SparseMatrix<double>& matrix, const std::function<bool()>& go_on = {})
  {
    m_is_factorized = false;
    if(go_on && !go_on())
      return error_cancelled;
    m_claim.take();
    m_matrix = std::make_unique<Matrix>(int(matrix.rows()));
    for(int j = 0; j < matrix.outerSize(); ++j)
      for(Eigen::SparseMatrix<double>::InnerIterator it(matrix, j); it; ++it)
        m_matrix->set_coef(int(it.row()), int(it.col()), NT(it.value()), true);
    m_is_factorized = m_traits.factor(*m_matrix, m_denominator);
    return m_is_factorized ? ok : error_cannot_solve_linear_system;
  }

  // `solution` may be `right`. Without a factor, it is an error.
  Error_code solve(const Eigen::MatrixXd& right, Eigen::MatrixXd& solution, const std::function<bool()>& go_on = {})
  {
    if(!has_factor())
      return error_cannot_solve_linear_system;
    const int n = int(right.rows());
    solution.resize(n, right.cols());
    for(int channel = 0; channel < int(right.cols()); ++channel)
    {
      if(go_on && !go_on())
        return error_cancelled;
      Vector b(n), x(n);
      for(int i = 0; i < n; ++i)
      {
        b[i] = NT(right(i, channel));
        x[i] = NT(0);
      }
      if(!m_traits.linear_solver(b, x))
        return error_cannot_solve_linear_system;
      for(int i = 0; i < n; ++i)
        solution(i, channel) = to_double(x[i] / m_denominator);
    }
    return ok;
  }

private:
  static const void* all_of_the_type()
  {
    static const char address = 0;
    return &address;
  }
};

// Solvers of Eigen: the symbolic analysis is done once, and all channels are solved together.
template <class EigenSolver>
class Linear_solver<Eigen_solver_traits<EigenSolver> >
{
  typedef Eigen_solver_handling<EigenSolver> Handling;

  Eigen_solver_traits<EigenSolver> m_traits; // shares its solver with the caller's copy
  std::unique_ptr<Eigen::SparseMatrix<double> > m_matrix; // some read it as they solve: iterative ones, UMFPACK
  Solver_claim m_claim;
  bool m_merges_small_fronts = false, m_is_analyzed = false, m_is_factorized = false;

public:
  static constexpr bool reads_lower_triangle = Handling::reads_lower_triangle;
  static constexpr bool is_iterative = std::is_base_of<Eigen::IterativeSolverBase<EigenSolver>, EigenSolver>::value;
  static constexpr bool needs_order = !is_iterative;
  // of ours, which need no more than their factor
  static constexpr bool is_cholesky = reads_lower_triangle && !is_iterative;

  explicit Linear_solver(const Eigen_solver_traits<EigenSolver>& traits)
    : m_traits(traits)
    , m_claim(&m_traits.solver())
  {
  }

  void merge_small_fronts() { m_merges_small_fronts = true; }

  Error_code analyze(const Eigen::SparseMatrix<double>& matrix)
  {
    m_is_analyzed = m_is_factorized = false;
    if constexpr (!is_iterative)
    {
      m_claim.take();
      const Error_code code = guarded([&] {
        m_traits.solver().analyzePattern(matrix);
        Handling::release_workspace(m_traits.solver());
        return !Handling::has_failed(m_traits.solver());
      });
      m_is_analyzed = code == ok;
      return code;
    }
    return ok;
  }

  bool has_factor() const { return m_is_factorized && m_claim.is_last(); }

  Error_code factorize(const Eigen::SparseMatrix<double>& matrix, const std::function<bool()>& go_on = {})
  {
    m_is_factorized = false;
    if(go_on && !go_on())
      return error_cancelled;
    if(!is_iterative && !(m_is_analyzed && m_claim.is_last()))
      if(const Error_code code = analyze(matrix))
        return code;
    m_claim.take();
    const Error_code code = guarded([&] {
      if constexpr (is_cholesky)
      {
        m_traits.solver().factorize(matrix);
        Handling::release_workspace(m_traits.solver());
      }
      else
      {
        m_matrix = std::make_unique<Eigen::SparseMatrix<double> >(matrix);
        if constexpr (is_iterative)
          m_traits.solver().compute(*m_matrix);
        else
          m_traits.solver().factorize(*m_matrix);
      }
      return m_traits.solver().info() == Eigen::Success;
    });
    m_is_factorized = code == ok;
    return code;
  }

  // `solution` may be `right`, which the solvers we know have read before they write it.
  Error_code solve(const Eigen::MatrixXd& right, Eigen::MatrixXd& solution, const std::function<bool()>& go_on = {})
  {
    if(!has_factor())
      return error_cannot_solve_linear_system;
    if(go_on && !go_on())
      return error_cancelled;
    const Error_code code = guarded([&] {
      if(&right == &solution && !is_cholesky)
        solution = m_traits.solver().solve(Eigen::MatrixXd(right)).eval();
      else
        solution = m_traits.solver().solve(right);
      return m_traits.solver().info() == Eigen::Success;
    });
    return code != ok && is_iterative ? error_not_converged : code;
  }

private:
  template <class Work>
  Error_code guarded(const Work& work)
  {
    const typename Handling::Work_scope scope(m_traits.solver(), m_merges_small_fronts);
    (void)scope;
    try { return work() ? ok : error_cannot_solve_linear_system; }
    catch(const std::bad_alloc&) { return error_cannot_solve_linear_system; }
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_LINEAR_SOLVER_H
