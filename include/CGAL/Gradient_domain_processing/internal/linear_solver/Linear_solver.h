// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_LINEAR_SOLVER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_LINEAR_SOLVER_H

#include <CGAL/Gradient_domain_processing/Default_sparse_linear_solver.h>
#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Sequential_blas_scope.h>

#include <Eigen/IterativeLinearSolvers>

#include <memory>
#include <new>
#include <type_traits>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// What is known of a solver of Eigen: whether the lower triangle of the matrix is all it reads.
template <class EigenSolver>
struct Reads_lower_triangle : std::false_type {};

template <class Matrix, class Ordering>
struct Reads_lower_triangle<Eigen::SimplicialLLT<Matrix, Eigen::Lower, Ordering> > : std::true_type {};
template <class Matrix, class Ordering>
struct Reads_lower_triangle<Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Ordering> > : std::true_type {};
template <class Matrix, class Preconditioner>
struct Reads_lower_triangle<Eigen::ConjugateGradient<Matrix, Eigen::Lower, Preconditioner> > : std::true_type {};
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
template <class Matrix>
struct Reads_lower_triangle<Eigen::CholmodSupernodalLLT<Matrix, Eigen::Lower> > : std::true_type {};
#endif

// The unknowns come in a fill-reducing order already, postordered; CHOLMOD shall not look for another, unless it was told to, nor
// copy the matrix to permute it.
template <class EigenSolver>
void keep_order(EigenSolver&) {}
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
template <class Matrix>
void keep_order(Eigen::CholmodSupernodalLLT<Matrix, Eigen::Lower>& solver)
{
  cholmod_common& common = solver.cholmod();
  if(common.print == 3) // its default: warnings on the terminal
    common.print = 0;
  if(common.nmethods == 0)
  {
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_NATURAL;
    common.postorder = 0;
  }
}
#endif

// Fewer and larger fronts, with some zeros in them: a third of the time where they are tiny, as in a graph of degree three, for a
// factor that is larger by as much.
template <class EigenSolver>
void merge_small_fronts(EigenSolver&) {}
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
template <class Matrix>
void merge_small_fronts(Eigen::CholmodSupernodalLLT<Matrix, Eigen::Lower>& solver)
{
  std::size_t (&columns)[3] = solver.cholmod().nrelax;
  if(columns[0] == 4 && columns[1] == 16 && columns[2] == 48) // its defaults
  {
    columns[0] = 12;
    columns[1] = 32;
    columns[2] = 64;
  }
}
#endif

// What a solver needs while it works only, and would keep.
template <class EigenSolver>
void release_workspace(EigenSolver&) {}
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
template <int options, int triangle>
void release_workspace(Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double, options, int>, triangle>& solver)
{
  cholmod_free_work(&solver.cholmod());
}
#endif

// Lives while the solver works: CHOLMOD does so on one thread, any other solver as it was set up.
template <class EigenSolver>
struct Thread_scope {};
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
template <class Matrix, int triangle>
struct Thread_scope<Eigen::CholmodSupernodalLLT<Matrix, triangle> > : Sequential_blas_scope {};
#endif

template <class EigenSolver>
bool out_of_memory(EigenSolver&) { return false; }
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
template <class Matrix>
bool out_of_memory(Eigen::CholmodSupernodalLLT<Matrix, Eigen::Lower>& solver)
{
  return solver.cholmod().status < 0;
}
#endif

// The one place that talks to linear solvers. This is for any model of SparseLinearAlgebraWithFactorTraits_d: the matrix is
// handed over entry by entry and the channels are solved one after the other.
template <class SolverTraits>
class Linear_solver
{
  typedef typename SolverTraits::Matrix Matrix;
  typedef typename SolverTraits::Vector Vector;
  typedef typename SolverTraits::NT NT;

  SolverTraits m_traits;
  std::unique_ptr<Matrix> m_matrix; // factor() may keep a pointer to it
  NT m_denominator = NT(1);         // solutions are multiples of it

public:
  static constexpr bool reads_lower_triangle = false;
  static constexpr bool is_iterative = false;

  explicit Linear_solver(const SolverTraits& traits) : m_traits(traits) {}

  void merge_small_fronts() {}

  Error_code analyze(const Eigen::SparseMatrix<double>&) { return OK; }

  Error_code factorize(const Eigen::SparseMatrix<double>& matrix)
  {
    m_matrix = std::make_unique<Matrix>(int(matrix.rows()));
    for(int j = 0; j < matrix.outerSize(); ++j)
      for(Eigen::SparseMatrix<double>::InnerIterator it(matrix, j); it; ++it)
        m_matrix->set_coef(it.row(), it.col(), NT(it.value()), true);
    return m_traits.factor(*m_matrix, m_denominator) ? OK : ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  }

  // `solution` may be `right`.
  Error_code solve(const Eigen::MatrixXd& right, Eigen::MatrixXd& solution)
  {
    const int n = int(right.rows());
    solution.resize(n, right.cols());
    for(int channel = 0; channel < right.cols(); ++channel)
    {
      Vector b(n), x(n);
      for(int i = 0; i < n; ++i)
      {
        b[i] = NT(right(i, channel));
        x[i] = NT(0);
      }
      if(!m_traits.linear_solver(b, x))
        return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
      for(int i = 0; i < n; ++i)
        solution(i, channel) = to_double(x[i] / m_denominator);
    }
    return OK;
  }
};

// Solvers of Eigen: the symbolic analysis is done once, and all channels are solved together.
template <class EigenSolver>
class Linear_solver<Eigen_solver_traits<EigenSolver> >
{
  Eigen_solver_traits<EigenSolver> m_traits; // shares its solver with the caller's copy
  Eigen::SparseMatrix<double> m_matrix;      // some read it as they solve: iterative ones, UMFPACK

public:
  static constexpr bool reads_lower_triangle = Reads_lower_triangle<EigenSolver>::value;
  static constexpr bool is_iterative = std::is_base_of<Eigen::IterativeSolverBase<EigenSolver>, EigenSolver>::value;
  static constexpr bool is_cholesky = reads_lower_triangle && !is_iterative; // of ours, which need no more than their factor

  explicit Linear_solver(const Eigen_solver_traits<EigenSolver>& traits) : m_traits(traits) {}

  void merge_small_fronts() { internal::merge_small_fronts(m_traits.solver()); }

  Error_code analyze(const Eigen::SparseMatrix<double>& matrix)
  {
    if constexpr (is_iterative)
      return OK;
    else
      return guarded([&] {
        keep_order(m_traits.solver());
        m_traits.solver().analyzePattern(matrix);
        release_workspace(m_traits.solver());
        return !out_of_memory(m_traits.solver());
      });
  }

  Error_code factorize(const Eigen::SparseMatrix<double>& matrix)
  {
    return guarded([&] {
      if constexpr (is_cholesky)
      {
        m_traits.solver().factorize(matrix);
        release_workspace(m_traits.solver());
      }
      else
      {
        m_matrix = matrix;
        if constexpr (is_iterative)
          m_traits.solver().compute(m_matrix);
        else
          m_traits.solver().factorize(m_matrix);
      }
      return m_traits.solver().info() == Eigen::Success;
    });
  }

  // `solution` may be `right`, which the solvers we know have read before they write it.
  Error_code solve(const Eigen::MatrixXd& right, Eigen::MatrixXd& solution)
  {
    const Error_code code = guarded([&] {
      if(&right == &solution && !is_cholesky)
        solution = m_traits.solver().solve(Eigen::MatrixXd(right)).eval();
      else
        solution = m_traits.solver().solve(right);
      return m_traits.solver().info() == Eigen::Success;
    });
    return code != OK && is_iterative ? ERROR_NOT_CONVERGED : code;
  }

private:
  template <class Work>
  static Error_code guarded(const Work& work)
  {
    const Thread_scope<EigenSolver> scope{};
    (void)scope;
    try { return work() ? OK : ERROR_CANNOT_SOLVE_LINEAR_SYSTEM; }
    catch(const std::bad_alloc&) { return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM; }
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_LINEAR_SOLVER_H
