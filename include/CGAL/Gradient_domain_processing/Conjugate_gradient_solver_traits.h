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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_CONJUGATE_GRADIENT_SOLVER_TRAITS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_CONJUGATE_GRADIENT_SOLVER_TRAITS_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/internal/linear_solver/multigrid/Conjugate_gradient.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Any_linear_solver.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Solver_claim.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_for.h>

#include <CGAL/Eigen_matrix.h>
#include <CGAL/Eigen_vector.h>
#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <functional>
#include <memory>
#include <new>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * solves symmetric positive definite systems by conjugate gradients, preconditioned by an algebraic multigrid method
 * (smoothed aggregation). It is for large meshes: memory grows linearly with the mesh, everything uses all threads, and
 * one solution of a hundred thousand unknowns or more takes less time than a factorization. The number of iterations
 * hardly grows with the mesh (24 at a million unknowns, 25 at ten million, down to \f$ 10^{-10} \f$), and more with
 * strong anisotropy; vertices that slivers bind to their neighbors are eliminated beforehand. Where many signals are
 * processed with one matrix on few cores, the default solver is faster.
 *
 * The iteration starts from zero. As this package solves for the change of a signal, that is a start from the signal
 * itself.
 *
 * A solution is accepted when \f$ \|r\|_B \leq \tau \|b\|_B \f$ for the residual \f$ r \f$ and the right-hand side \f$
 * b \f$, with
 * \f$ \tau \f$ the tolerance and \f$ B \approx A^{-1} \f$ the preconditioner. This is about the error of the solution
 * in the norm of the energy, relative to the solution, as far as \f$ B \f$ is good. Where the maximum number of
 * iterations does not reach it, functions of this package solve by `Default_sparse_linear_solver` and tell the visitor
 * in a notice; with more than a million degrees of freedom, for which a factor may be too large, they return
 * `error_not_converged`.
 *
 * Copies share their state: the object whose copy is passed to a function has the numbers of iterations afterwards.
 *
 * \tparam ConcurrencyTag enables parallel computation. The result is the same to the bit either way.
 *
 * \cgalModels{SparseLinearAlgebraWithFactorTraits_d}
 *
 * \sa `Default_sparse_linear_solver`
 */
template <class ConcurrencyTag = Parallel_if_available_tag>
class Conjugate_gradient_solver_traits
{
  std::shared_ptr<internal::Conjugate_gradient> m_solver = std::make_shared<internal::Conjugate_gradient>();

public:
  /// \name Types
  /// @{

  /// the number type
  typedef double NT;
  /// a square matrix. Both its triangles must be set.
  typedef Eigen_sparse_matrix<double> Matrix;
  /// a vector
  typedef Eigen_vector<double> Vector;

  /// @}

  /// \name Construction
  /// @{

  /*!
   * \param tolerance \f$ \tau \f$, positive
   * \param maximum_number_of_iterations after so many iterations it is given up
   */
  explicit Conjugate_gradient_solver_traits(double tolerance = 1e-10, int maximum_number_of_iterations = 500)
  {
    m_solver->tolerance = tolerance;
    m_solver->max_iterations = maximum_number_of_iterations;
    m_solver->parallel = internal::is_parallel<ConcurrencyTag>();
  }

  /// @}

  /// \name Operations
  /// @{

  /// prepares the solution of \f$ A X = B \f$. The matrix is copied. Returns `false` if a diagonal entry is not
  /// positive: the matrix is not positive definite then. \f$ D \f$ becomes 1.
  bool factor(const Matrix& A, NT& D)
  {
    CGAL_precondition(A.row_dimension() == A.column_dimension());
    D = 1;
    return m_solver->compute(A.eigen_object());
  }

  /// solves \f$ A X = B \f$ with the matrix of the last `factor()`. Returns whether the tolerance was reached.
  bool linear_solver(const Vector& B, Vector& X)
  {
    Eigen::MatrixXd solution;
    const bool has_converged = m_solver->solve(B.eigen_object(), solution);
    X.eigen_object() = solution.col(0);
    return has_converged;
  }

  /// solves \f$ A X = B \f$. Returns whether it succeeded.
  bool linear_solver(const Matrix& A, const Vector& B, Vector& X, NT& D) { return factor(A, D) && linear_solver(B, X); }

  /// @}

  /// \name The Last Solution
  /// @{

  /// the number of iterations, of the channel that took most
  int iterations() const { return m_solver->iterations; }

  /// the relative error that was reached, as it is compared with the tolerance; of the channel that has most
  double error() const { return m_solver->error; }

  /// @}

  /// \cond SKIP_IN_MANUAL
  internal::Conjugate_gradient& solver() { return *m_solver; }
  /// \endcond
};

namespace internal {

template <class ConcurrencyTag>
class Linear_solver<Conjugate_gradient_solver_traits<ConcurrencyTag> >
{
  Conjugate_gradient_solver_traits<ConcurrencyTag> m_traits; // shares its state with the caller's copy
  Solver_claim m_claim;
  bool m_is_factorized = false;

public:
  static constexpr bool reads_lower_triangle = false;
  static constexpr bool is_iterative = true;
  static constexpr bool needs_order = false;

  explicit Linear_solver(const Conjugate_gradient_solver_traits<ConcurrencyTag>& traits)
    : m_traits(traits)
    , m_claim(&m_traits.solver())
  {
  }

  void merge_small_fronts() {}

  Error_code analyze(const Eigen::SparseMatrix<double>&) { return ok; }

  bool has_factor() const { return m_is_factorized && m_claim.is_last(); }

  Error_code factorize(const Eigen::SparseMatrix<double>& matrix, const std::function<bool()>& go_on = {})
  {
    m_is_factorized = false;
    m_claim.take();
    try { m_is_factorized = m_traits.solver().compute(matrix, go_on); }
    catch(const std::bad_alloc&) { return error_cannot_solve_linear_system; }
    return m_is_factorized ? ok : m_traits.solver().is_cancelled ? error_cancelled : error_cannot_solve_linear_system;
  }

  Error_code solve(const Eigen::MatrixXd& right, Eigen::MatrixXd& solution, const std::function<bool()>& go_on = {})
  {
    if(!has_factor())
      return error_cannot_solve_linear_system;
    try
    {
      if(m_traits.solver().solve(right, solution, go_on))
        return ok;
      return m_traits.solver().is_cancelled ? error_cancelled : error_not_converged;
    }
    catch(const std::bad_alloc&) { return error_cannot_solve_linear_system; }
  }
};

#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
extern template std::unique_ptr<Any_linear_solver> any_linear_solver(
  const Conjugate_gradient_solver_traits<Parallel_if_available_tag>&);
#endif

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_CONJUGATE_GRADIENT_SOLVER_TRAITS_H
