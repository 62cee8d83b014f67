// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_AGGREGATION_MULTIGRID_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_AGGREGATION_MULTIGRID_H

#include <CGAL/Gradient_domain_processing/internal/linear_solver/multigrid/Sparse_rows.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/multigrid/Stiff_elimination.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Smoothed aggregation multigrid (after Vanek, Mandel, Brezina 1996) as a preconditioner: one symmetric V-cycle. Coarser
// unknowns are groups of strongly connected finer ones; where the mass dominates there are none, and the smoother is enough.
template <class Real>
class Aggregation_multigrid
{
  typedef Sparse_rows<Real> Matrix;

  // Rows of a block are smoothed one after the other, blocks side by side.
  static constexpr std::size_t block_size = 8192;
  static constexpr int max_coarsest_size = 500;

  struct Level
  {
    Matrix matrix, prolongation, restriction;
    std::vector<Real> inverse_diagonal; // of the smoother
    std::vector<Real> right, solution, residual;
  };

  // What comes before the levels, where there are slivers.
  struct Elimination_level
  {
    Stiff_elimination<Real> elimination;
    std::vector<Real> right, solution; // after it
  };

  static constexpr int max_number_of_eliminations = 12; // slivers that hang together take several

  Matrix m_finest; // where it is not that of the first level
  std::vector<Elimination_level> m_eliminations;
  std::vector<Level> m_levels;
  Eigen::LLT<Eigen::MatrixXd> m_coarsest;
  bool m_solves_coarsest = false;
  bool m_parallel = true;

public:
  // Builds the hierarchy. Returns whether the diagonal is positive, as it is in every positive definite matrix; and false where
  // `go_on`, asked at every level, answered so.
  bool compute(Matrix matrix, bool parallel, const std::function<bool()>& go_on = {})
  {
    m_parallel = parallel;
    m_levels.clear();
    m_eliminations.clear();
    Matrix().swap(m_finest);
    eliminate_stiff(matrix);
    m_solves_coarsest = false;
    double threshold = 0.08;
    while(!go_on || go_on())
    {
      m_levels.emplace_back();
      Level& level = m_levels.back();
      level.matrix = std::move(matrix);
      if(!prepare_smoother(level))
        return false;
      if(level.matrix.rows() <= max_coarsest_size)
      {
        factorize_coarsest(level.matrix);
        return true;
      }
      level.prolongation = prolongation(level.matrix, Real(threshold));
      if(level.prolongation.columns == 0)
        return true;
      level.restriction = transpose(level.prolongation);
      matrix = galerkin_product(level);
      threshold /= 2;
    }
    return false;
  }

  // x = V b for K channels that lie together.
  template <int K, class Scalar>
  void apply(const std::vector<Scalar>& b, std::vector<Scalar>& x)
  {
    for(Level& level : m_levels)
    {
      const std::size_t size = K * std::size_t(level.matrix.rows());
      if(&level != &m_levels.front())
      {
        level.right.resize(size);
        level.solution.resize(size);
      }
      level.residual.resize(size);
    }
    if(m_eliminations.empty())
      cycle<K>(0, b, x);
    else
      eliminate_and_cycle<K>(0, b, x);
  }

  const Matrix& finest() const { return m_eliminations.empty() ? m_levels.front().matrix : m_finest; }

private:
  void eliminate_stiff(Matrix& matrix)
  {
    for(int count = 0; count < max_number_of_eliminations; ++count)
    {
      Elimination_level level;
      Matrix remainder;
      if(!level.elimination.eliminate(matrix, m_parallel, remainder))
        return;
      if(count == 0)
        m_finest.swap(matrix);
      matrix.swap(remainder);
      m_eliminations.push_back(std::move(level));
    }
  }

  template <int K, class B, class X>
  void eliminate_and_cycle(std::size_t depth, const B& b, X& x)
  {
    Elimination_level& level = m_eliminations[depth];
    level.elimination.template restrict_to<K>(b, level.right, m_parallel);
    level.solution.resize(level.right.size());
    if(depth + 1 < m_eliminations.size())
      eliminate_and_cycle<K>(depth + 1, level.right, level.solution);
    else
      cycle<K>(0, level.right, level.solution);
    level.elimination.template prolongate<K>(b, level.solution, x, m_parallel);
  }

  template <int K, class B, class X>
  void cycle(std::size_t depth, const B& b, X& x)
  {
    Level& level = m_levels[depth];
    if(m_solves_coarsest && depth + 1 == m_levels.size())
    {
      solve_coarsest<K>(b, x);
      return;
    }
    smooth_forward<K>(level, b, x);
    if(depth + 1 < m_levels.size())
    {
      Level& coarser = m_levels[depth + 1];
      subtract_product<K>(level, b, x);
      level.restriction.template multiply<K>(level.residual, coarser.right, m_parallel);
      cycle<K>(depth + 1, coarser.right, coarser.solution);
      add_product<K>(level.prolongation, coarser.solution, x);
    }
    smooth_backward<K>(level, b, x);
  }

  // The smoother is Gauss-Seidel within blocks. What a row of a block has in common with other blocks is added to its diagonal:
  // then it converges for every positive definite matrix (Baker, Falgout, Kolev, Yang 2011).
  bool prepare_smoother(Level& level) const
  {
    const Matrix& a = level.matrix;
    level.inverse_diagonal.resize(a.rows());
    std::vector<char> is_positive(a.rows());
    for_each_block(m_parallel, a.rows(), block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
      {
        Real own = 0, others = 0;
        for(int e = a.offset[i]; e < a.offset[i + 1]; ++e)
        {
          const std::size_t j = a.column[e];
          if(j == i)
            own += a.value[e];
          else if(j < begin || j >= end)
            others += std::abs(a.value[e]);
        }
        is_positive[i] = own > 0;
        level.inverse_diagonal[i] = 1 / (own + others);
      }
    });
    return std::find(is_positive.begin(), is_positive.end(), 0) == is_positive.end();
  }

  // One sweep that starts from x = 0, to which what comes later in the block does not contribute.
  template <int K, class B, class X>
  void smooth_forward(const Level& level, const B& b, X& x) const
  {
    const Matrix& a = level.matrix;
    for_each_block(m_parallel, a.rows(), block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
      {
        Real sum[K];
        for(int c = 0; c < K; ++c)
          sum[c] = Real(b[K * i + c]);
        for(int e = a.offset[i]; e < a.offset[i + 1]; ++e)
        {
          const std::size_t j = a.column[e];
          if(j >= begin && j < i)
            for(int c = 0; c < K; ++c)
              sum[c] -= a.value[e] * Real(x[K * j + c]);
        }
        for(int c = 0; c < K; ++c)
          x[K * i + c] = sum[c] * level.inverse_diagonal[i];
      }
    });
  }

  // One sweep in the opposite order, the adjoint of the other. Blocks read each other's old values, which are set aside.
  template <int K, class B, class X>
  void smooth_backward(Level& level, const B& b, X& x) const
  {
    const Matrix& a = level.matrix;
    for_each_block(m_parallel, level.residual.size(), block_size,
                   [&](std::size_t begin, std::size_t end) { std::copy(&x[begin], &x[begin] + (end - begin), &level.residual[begin]); });
    for_each_block(m_parallel, a.rows(), block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = end; i-- > begin; )
      {
        Real sum[K];
        for(int c = 0; c < K; ++c)
          sum[c] = Real(b[K * i + c]);
        for(int e = a.offset[i]; e < a.offset[i + 1]; ++e)
        {
          const std::size_t j = a.column[e];
          const auto* at = j >= begin && j < end ? &x[K * j] : &level.residual[K * j];
          for(int c = 0; c < K; ++c)
            sum[c] -= a.value[e] * Real(at[c]);
        }
        for(int c = 0; c < K; ++c)
          x[K * i + c] += sum[c] * level.inverse_diagonal[i];
      }
    });
  }

  // residual = b - A x
  template <int K, class B, class X>
  void subtract_product(Level& level, const B& b, const X& x) const
  {
    for_each_block(m_parallel, level.matrix.rows(), block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
      {
        Real sum[K];
        level.matrix.template multiply_row<K>(i, x, sum);
        for(int c = 0; c < K; ++c)
          level.residual[K * i + c] = Real(b[K * i + c]) - sum[c];
      }
    });
  }

  template <int K, class X, class Y>
  void add_product(const Matrix& a, const X& x, Y& y) const
  {
    for_each_block(m_parallel, a.rows(), block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
      {
        Real sum[K];
        a.template multiply_row<K>(i, x, sum);
        for(int c = 0; c < K; ++c)
          y[K * i + c] += sum[c];
      }
    });
  }

  void factorize_coarsest(const Matrix& a)
  {
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(a.rows(), a.rows());
    for(int i = 0; i < a.rows(); ++i)
      for(int e = a.offset[i]; e < a.offset[i + 1]; ++e)
        dense(i, a.column[e]) += a.value[e];
    m_coarsest.compute(dense);
    m_solves_coarsest = m_coarsest.info() == Eigen::Success;
  }

  template <int K, class B, class X>
  void solve_coarsest(const B& b, X& x) const
  {
    const int n = int(m_coarsest.rows());
    Eigen::MatrixXd block(n, K);
    for(int i = 0; i < n; ++i)
      for(int c = 0; c < K; ++c)
        block(i, c) = b[K * i + c];
    m_coarsest.solveInPlace(block);
    for(int i = 0; i < n; ++i)
      for(int c = 0; c < K; ++c)
        x[K * i + c] = block(i, c);
  }

  // Strong couplings pull two unknowns together; those of obtuse angles and of the mass push, and are not among them.
  static bool is_strong(Real coupling, Real d_i, Real d_j, Real threshold)
  {
    return coupling < 0 && coupling * coupling > threshold * threshold * d_i * d_j;
  }

  // P = (I - omega D^-1 A') T: T has a column for every aggregate, A' is the matrix with its weak couplings moved to the
  // diagonal D. A' is diagonally dominant, which bounds D^-1 A' by 2 and gives the best omega, 4/3 of the bound's inverse.
  Matrix prolongation(const Matrix& a, Real threshold) const
  {
    const Real omega = Real(2. / 3);
    const std::vector<Real> diagonal = a.diagonal();
    std::vector<int> aggregate;
    const int number_of_aggregates = aggregate_unknowns(a, diagonal, threshold, aggregate);
    return build_rows<Real>(m_parallel, a.rows(), number_of_aggregates, [&](std::size_t i, auto& row) {
      if(aggregate[i] < 0)
        return;
      Real filtered = 0, strong = 0;
      for(int e = a.offset[i]; e < a.offset[i + 1]; ++e)
        if(is_strong(a.value[e], diagonal[i], diagonal[a.column[e]], threshold))
          strong -= a.value[e];
        else
          filtered += a.value[e];
      filtered = (std::max)(filtered, strong); // obtuse angles at constrained vertices may leave less
      for(int e = a.offset[i]; e < a.offset[i + 1]; ++e)
      {
        const int j = a.column[e];
        if(is_strong(a.value[e], diagonal[i], diagonal[j], threshold) && aggregate[j] >= 0)
          row.add(aggregate[j], -omega * a.value[e] / filtered);
      }
      row.add(aggregate[i], 1 - omega);
    });
  }

  // An unknown whose strong neighbors are all free makes an aggregate with them; the others join the neighbor they are coupled
  // to most strongly. One without strong neighbors is in none.
  static int aggregate_unknowns(const Matrix& a, const std::vector<Real>& diagonal, Real threshold, std::vector<int>& aggregate)
  {
    const int n = a.rows();
    int count = 0;
    aggregate.assign(n, -1);
    for(int i = 0; i < n; ++i)
    {
      if(aggregate[i] >= 0)
        continue;
      bool is_free = true, has_neighbors = false;
      for(int e = a.offset[i]; e < a.offset[i + 1] && is_free; ++e)
        if(is_strong(a.value[e], diagonal[i], diagonal[a.column[e]], threshold))
        {
          has_neighbors = true;
          is_free = aggregate[a.column[e]] < 0;
        }
      if(!is_free || !has_neighbors)
        continue;
      aggregate[i] = count;
      for(int e = a.offset[i]; e < a.offset[i + 1]; ++e)
        if(is_strong(a.value[e], diagonal[i], diagonal[a.column[e]], threshold))
          aggregate[a.column[e]] = count;
      ++count;
    }

    const std::vector<int> roots = aggregate;
    for(int i = 0; i < n; ++i)
    {
      Real strongest = 0;
      for(int e = a.offset[i]; roots[i] < 0 && e < a.offset[i + 1]; ++e)
      {
        const int j = a.column[e];
        if(roots[j] >= 0 && a.value[e] < strongest && is_strong(a.value[e], diagonal[i], diagonal[j], threshold))
        {
          strongest = a.value[e];
          aggregate[i] = roots[j];
        }
      }
    }
    return count;
  }

  // P^T A P, a row at a time.
  Matrix galerkin_product(const Level& level) const
  {
    const Matrix &a = level.matrix, &p = level.prolongation, &r = level.restriction;
    return build_rows<Real>(m_parallel, r.rows(), r.rows(), [&](std::size_t row_index, auto& row) {
      for(int e = r.offset[row_index]; e < r.offset[row_index + 1]; ++e)
      {
        const int i = r.column[e];
        for(int f = a.offset[i]; f < a.offset[i + 1]; ++f)
        {
          const int j = a.column[f];
          const Real product = r.value[e] * a.value[f];
          for(int g = p.offset[j]; g < p.offset[j + 1]; ++g)
            row.add(p.column[g], product * p.value[g]);
        }
      }
    });
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_AGGREGATION_MULTIGRID_H
