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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_CONJUGATE_GRADIENT_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_CONJUGATE_GRADIENT_H

#include <CGAL/Gradient_domain_processing/internal/linear_solver/multigrid/Aggregation_multigrid.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/multigrid/Sparse_rows.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Conjugate gradients, preconditioned by multigrid. Several channels go through the matrix together, each with its own
// steps.
class Conjugate_gradient
{
  static constexpr int max_channels_together = 4;
  static constexpr std::size_t block_size = 8192;

  template <int K>
  using Channels = Aggregation_multigrid::Channels<K>;

  Aggregation_multigrid m_preconditioner;

public:
  double tolerance = 1e-10;
  int max_iterations = 1000;
  bool parallel = true;

  int iterations = 0; // of the last solution: the most of any channel
  double error = 0;   // likewise
  bool is_cancelled = false; // as `go_on` has answered to the last question

  // Builds the preconditioner for a symmetric matrix with both its triangles. Returns whether its diagonal is positive.
  bool compute(const Eigen::SparseMatrix<double>& matrix, const std::function<bool()>& go_on = {})
  {
    is_cancelled = false;
    return m_preconditioner.compute(rows_of(matrix), parallel, [&] { return asked(go_on); });
  }

  // Returns whether all channels, the columns, converged. `go_on` is asked at every iteration.
  bool solve(const Eigen::MatrixXd& right, Eigen::MatrixXd& solution, const std::function<bool()>& go_on = {})
  {
    is_cancelled = false;
    iterations = 0;
    error = 0;
    solution.resize(right.rows(), right.cols());
    bool has_converged = true;
    for(int first = 0; first < right.cols() && !is_cancelled; first += max_channels_together)
      switch((std::min)(int(right.cols()) - first, max_channels_together))
      {
        case 1: has_converged &= solve<1>(right, first, solution, go_on); break;
        case 2: has_converged &= solve<2>(right, first, solution, go_on); break;
        case 3: has_converged &= solve<3>(right, first, solution, go_on); break;
        case 4: has_converged &= solve<4>(right, first, solution, go_on); break;
      }
    return has_converged;
  }

private:
  bool asked(const std::function<bool()>& go_on)
  {
    is_cancelled = go_on && !go_on();
    return !is_cancelled;
  }

  // Symmetric: its columns are its rows.
  Sparse_rows<double> rows_of(const Eigen::SparseMatrix<double>& matrix) const
  {
    if(!matrix.isCompressed())
    {
      Eigen::SparseMatrix<double> compressed = matrix;
      compressed.makeCompressed();
      return rows_of(compressed);
    }
    const std::size_t size = std::size_t(matrix.nonZeros());
    Sparse_rows<double> rows;
    rows.columns = int(matrix.rows());
    rows.offset.assign(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.cols() + 1);
    rows.column.resize(size);
    rows.value.resize(size);
    for_each_block(parallel, size, 1 << 16, [&](std::size_t begin, std::size_t end) {
      std::copy(matrix.innerIndexPtr() + begin, matrix.innerIndexPtr() + end, rows.column.begin() + begin);
      std::copy(matrix.valuePtr() + begin, matrix.valuePtr() + end, rows.value.begin() + begin);
    });
    return rows;
  }

  // Starts from zero. The error is measured by |r|_B / |b|_B, where B is the preconditioner and about the inverse of A:
  // it is that of the solution in the norm of the energy, up to the quality of B.
  template <int K>
  bool solve(const Eigen::MatrixXd& right, int first, Eigen::MatrixXd& solution, const std::function<bool()>& go_on)
  {
    const std::size_t n = right.rows();
    Untouched_vector<double> x(K * n), r(K * n), p(K * n), z(K * n);
    for_each_row(n, [&](std::size_t i) {
      for(int c = 0; c < K; ++c)
      {
        r[K * i + c] = right(i, first + c);
        x[K * i + c] = p[K * i + c] = 0;
      }
    });

    Channels<K> step = Channels<K>::Zero(), curvature;
    m_preconditioner.begin<K>(r);
    Channels<K> rho = m_preconditioner.apply<K>(r, z, [](std::size_t, std::size_t) {}), old_rho = rho;
    const Channels<K> initial = rho, limit = tolerance * tolerance * initial;
    bool is_sound = (rho >= 0).all() && rho.allFinite();
    int count = 0;
    while(is_sound && (rho > limit).any() && count < max_iterations && asked(go_on))
    {
      const Channels<K> turn = count > 0 ? quotient<K>(rho, old_rho, rho > limit) : Channels<K>(Channels<K>::Zero());
      for_each_block(parallel, n, block_size, [&](std::size_t begin, std::size_t end) {
        const Channels<K> last_step = step, t = turn;
        for(std::size_t i = begin; i < end; ++i)
          for(int c = 0; c < K; ++c)
          {
            double& direction = p[K * i + c];
            x[K * i + c] += last_step[c] * direction; // x follows by one step
            direction = z[K * i + c] + t[c] * direction;
          }
      });
      curvature = product<K>(p, z);
      step = quotient<K>(rho, curvature, rho > limit);
      old_rho = rho;
      rho = m_preconditioner.apply<K>(r, z, [&](std::size_t begin, std::size_t end) {
        const Channels<K> s = step;
        for(std::size_t i = begin; i < end; ++i)
          for(int c = 0; c < K; ++c)
            r[K * i + c] -= s[c] * z[K * i + c];
      });
      is_sound = (rho >= 0).all() && rho.allFinite() && (curvature > 0 || old_rho <= limit).all();
      ++count;
    }

    for_each_row(n, [&](std::size_t i) {
      for(int c = 0; c < K; ++c)
        solution(i, first + c) = x[K * i + c] + step[c] * p[K * i + c];
    });
    iterations = (std::max)(iterations, count);
    for(int c = 0; c < K; ++c)
      if(initial[c] != 0)
        error = (std::max)(error, std::sqrt(rho[c] / initial[c]));
    return is_sound && !is_cancelled && (rho <= limit).all();
  }

  // Channels that have converged stay where they are.
  template <int K, class Condition>
  static Channels<K> quotient(const Channels<K>& a, const Channels<K>& b, const Condition& is_active)
  {
    return is_active.select(a / b, 0.);
  }

  template <class Body>
  void for_each_row(std::size_t n, const Body& body) const
  {
    for_each_block(parallel, n, block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
        body(i);
    });
  }

  // q = A p; returns p . q
  template <int K>
  Channels<K> product(const Untouched_vector<double>& p, Untouched_vector<double>& q) const
  {
    const Sparse_rows<double>& a = m_preconditioner.finest();
    const Channels<K> zero = Channels<K>::Zero();
    return sum_over_blocks(parallel, p.size() / K, block_size, zero, [&](std::size_t begin, std::size_t end) {
      Channels<K> sum = zero;
      const double* const from = p.data();
      double* const to = q.data();
      for(std::size_t i = begin; i < end; ++i)
      {
        Channels<K> row = zero;
        for(int e = a.offset[i]; e < a.offset[i + 1]; ++e)
          row += a.value[e] * Eigen::Map<const Channels<K> >(from + K * std::size_t(a.column[e]));
        for(int c = 0; c < K; ++c)
          to[K * i + c] = row[c];
        sum += row * Eigen::Map<const Channels<K> >(from + K * i);
      }
      return sum;
    });
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_CONJUGATE_GRADIENT_H
