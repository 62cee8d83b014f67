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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_AUTOMATIC_SPARSE_LINEAR_SOLVER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_AUTOMATIC_SPARSE_LINEAR_SOLVER_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/Conjugate_gradient_solver_traits.h>
#include <CGAL/Gradient_domain_processing/Default_sparse_linear_solver.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Any_linear_solver.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/time_estimate.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/number_of_threads.h>

#include <CGAL/Eigen_matrix.h>
#include <CGAL/Eigen_vector.h>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * solves each system by the one of two solvers that is expected to be done first: `Default_sparse_linear_solver`, a
 * Cholesky factorization, or `Conjugate_gradient_solver_traits`. The choice depends on the number of degrees of
 * freedom, on how far the weights reach, on the metric, on the number of processors, and on the memory that is free; on
 * small meshes it is Cholesky. For a matrix that is used once, conjugate gradients are the faster from some hundred
 * thousand vertices on, where there are four processors or more.
 *
 * Where the iteration does not converge, functions of this package solve by Cholesky factorization, as with
 * `Conjugate_gradient_solver_traits`. The choice is made when the pattern of the matrix is analyzed: for the weights
 * and the metric of that time. As it depends on the machine and what else runs on it, so do the last bits of results.
 * Copies share the answer of `has_iterated()`.
 *
 * \cgalModels{SparseLinearAlgebraWithFactorTraits_d}
 *
 * \sa `Default_sparse_linear_solver`
 * \sa `Conjugate_gradient_solver_traits`
 */
class Automatic_sparse_linear_solver
{
  double m_tolerance;
  int m_number_of_solutions;
  double m_memory;
  std::shared_ptr<std::atomic<bool> > m_has_iterated = std::make_shared<std::atomic<bool> >(false);
  std::shared_ptr<internal::Any_linear_solver> m_solver;                   // of factor()
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> m_order;  // likewise, where one is needed

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
   * \param tolerance that of `Conjugate_gradient_solver_traits`
   * \param number_of_solutions how often a solution is expected to be asked for with one matrix, as with
   *        `Gradient_domain_solver`: a factorization is worth more then
   * \param memory the bytes that a factor may take; 0 for those that are free when the choice is made
   */
  explicit Automatic_sparse_linear_solver(double tolerance = 1e-10, int number_of_solutions = 1, double memory = 0)
    : m_tolerance(tolerance), m_number_of_solutions((std::max)(1, number_of_solutions)), m_memory(memory)
  {}

  /// @}

  /// \name Operations
  /// @{

  /// prepares the solution of \f$ A X = B \f$. Returns `false` if the matrix is found not to be positive definite.
  /// \f$ D \f$ becomes 1.
  bool factor(const Matrix& A, NT& D)
  {
    internal::Solver_task task;
    task.unknowns = std::size_t(A.row_dimension());
    task.channels = 1;
    task.gradient_weight = 1; // not known
    task.cores = internal::number_of_threads(true);
    D = 1;
    m_solver = choose(task);
    m_order.setIdentity(A.row_dimension());
    Eigen::SparseMatrix<double> matrix = A.eigen_object();
    if(m_solver->needs_order())
    {
      Eigen::AMDOrdering<int>()(matrix.selfadjointView<Eigen::Lower>(), m_order);
      Eigen::SparseMatrix<double> ordered(matrix.rows(), matrix.cols());
      ordered.selfadjointView<Eigen::Lower>() = matrix.selfadjointView<Eigen::Lower>().twistedBy(m_order.inverse());
      matrix.swap(ordered); // its lower triangle
    }
    if(m_solver->reads_lower_triangle())
      matrix = Eigen::SparseMatrix<double>(matrix.triangularView<Eigen::Lower>());
    return m_solver->analyze(matrix) == ok && m_solver->factorize(matrix, {}) == ok;
  }

  /// solves \f$ A X = B \f$ with the matrix of the last `factor()`. Returns whether it succeeded.
  bool linear_solver(const Vector& B, Vector& X)
  {
    Eigen::MatrixXd solution;
    if(!m_solver || m_solver->solve(Eigen::MatrixXd(m_order.inverse() * B.eigen_object()), solution, {}) != ok)
      return false;
    X.eigen_object() = m_order * solution.col(0);
    return true;
  }

  /// solves \f$ A X = B \f$. Returns whether it succeeded.
  bool linear_solver(const Matrix& A, const Vector& B, Vector& X, NT& D) { return factor(A, D) && linear_solver(B, X); }

  /// @}

  /// whether conjugate gradients were chosen last, by this object or a copy of it
  bool has_iterated() const { return *m_has_iterated; }

  /// \cond SKIP_IN_MANUAL
  std::unique_ptr<internal::Any_linear_solver> choose(internal::Solver_task task) const
  {
    task.solutions_of_each = m_number_of_solutions;
    const bool iterates = internal::multigrid_pays(task, m_memory > 0 ? m_memory : internal::available_memory());
    *m_has_iterated = iterates;
    if(iterates)
      return internal::any_linear_solver(Conjugate_gradient_solver_traits<>(m_tolerance));
    return internal::any_linear_solver(Default_sparse_linear_solver());
  }
  /// \endcond
};

namespace internal {

// Chooses when it is told what is to be done.
template <>
class Any_linear_solver_of<Automatic_sparse_linear_solver> : public Any_linear_solver
{
  Automatic_sparse_linear_solver m_traits;
  std::unique_ptr<Any_linear_solver> m_chosen;

public:
  explicit Any_linear_solver_of(const Automatic_sparse_linear_solver& traits)
    : m_traits(traits), m_chosen(traits.choose(Solver_task()))
  {}

  void prepare(const Solver_task& task) override { m_chosen = m_traits.choose(task); }

  bool reads_lower_triangle() const override { return m_chosen->reads_lower_triangle(); }
  bool is_iterative() const override { return m_chosen->is_iterative(); }
  bool needs_order() const override { return m_chosen->needs_order(); }
  Error_code analyze(const Eigen::SparseMatrix<double>& matrix) override { return m_chosen->analyze(matrix); }
  bool has_factor() const override { return m_chosen->has_factor(); }
  Error_code factorize(const Eigen::SparseMatrix<double>& matrix, const std::function<bool()>& go_on) override
  {
    return m_chosen->factorize(matrix, go_on);
  }
  Error_code solve(const Eigen::MatrixXd& right, Eigen::MatrixXd& solution, const std::function<bool()>& go_on) override
  {
    return m_chosen->solve(right, solution, go_on);
  }
};

} // namespace internal

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_AUTOMATIC_SPARSE_LINEAR_SOLVER_H
