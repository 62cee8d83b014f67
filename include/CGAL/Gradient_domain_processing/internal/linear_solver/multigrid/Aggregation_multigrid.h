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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_AGGREGATION_MULTIGRID_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_AGGREGATION_MULTIGRID_H

#include <CGAL/Gradient_domain_processing/internal/linear_solver/multigrid/Block_smoother.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/multigrid/Lanes.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/multigrid/Sparse_rows.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/multigrid/Stiff_elimination.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/multigrid/aggregation.h>
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

// Aggregation multigrid as a preconditioner: one symmetric V-cycle. It is built in double precision, as the mass of a
// large mesh is lost beside its stiffness in single; it works in single, as errors of its own cost no more than a
// fraction of an iteration.
class Aggregation_multigrid
{
  typedef Sparse_rows<double> Matrix;

  static constexpr double strength_threshold = 0.08; // of couplings relative to the diagonals, on all levels
  static constexpr int max_coarsest_size = 256;
  static constexpr int max_channels = 4;

  struct Level
  {
    Block_smoother smoother;
    Sparse_rows<float> prolongation, restriction; // to and from the next, divided by the diagonals as the smoother is
    std::vector<float> right, solution, residual;
  };

  Matrix m_finest;
  Stiff_elimination m_elimination; // comes before the levels
  std::vector<Level> m_levels;
  Eigen::LLT<Eigen::MatrixXd> m_coarsest;
  bool m_solves_coarsest = false;
  bool m_parallel = true;
  double m_scale[max_channels] = {1, 1, 1, 1}; // brings a channel into the range of single precision

public:
  template <int K>
  using Channels = Eigen::Array<double, K, 1>;

  // Builds the hierarchy. Returns whether the diagonal is positive, as it is in every positive definite matrix; and
  // false where `go_on`, asked at every level, answered so.
  bool compute(Matrix matrix, bool parallel, const std::function<bool()>& go_on = {})
  {
    m_parallel = parallel;
    m_levels.clear();
    m_finest = std::move(matrix);
    matrix = Matrix();
    m_elimination.eliminate(m_finest, m_parallel, matrix);
    const Matrix* finer = m_elimination.empty() ? &m_finest : &matrix;
    m_solves_coarsest = false;
    Matrix restriction;
    while(!go_on || go_on())
    {
      m_levels.emplace_back();
      Level& level = m_levels.back();
      if(!level.smoother.prepare(*finer, m_parallel))
        return false;
      if(m_levels.size() > 1)
        finish_restriction(restriction, m_levels[m_levels.size() - 2], level);
      if(finer->rows() <= max_coarsest_size)
      {
        factorize_coarsest(*finer);
        return true;
      }
      const Matrix p = prolongation(*finer, strength_threshold, m_parallel);
      if(p.columns == 0)
        return true;
      level.prolongation = in_single_precision(p);
      restriction = transpose(p, m_parallel);
      matrix = galerkin_product(*finer, p, restriction, m_parallel);
      finer = &matrix;
    }
    return false;
  }

  const Matrix& finest() const { return m_finest; }

  // To be called before a series of apply(), with the largest right-hand side, which is left as it was.
  template <int K>
  void begin(Untouched_vector<double>& b)
  {
    m_elimination.restrict_to<K>(b);
    const std::vector<double>& inverse_diagonal = m_levels.front().smoother.inverse_diagonal();
    const std::size_t n = inverse_diagonal.size();
    std::vector<Channels<K> > largest_of_block(n / block_size + 1, Channels<K>(Channels<K>::Zero()));
    for_each_block(m_parallel, n, block_size, [&](std::size_t begin, std::size_t end) {
      Channels<K> largest = Channels<K>::Zero();
      for(std::size_t i = begin; i < end; ++i)
        for(int c = 0; c < K; ++c)
          largest[c] = (std::max)(largest[c], std::abs(b[K * i + c] * inverse_diagonal[i]));
      largest_of_block[begin / block_size] = largest;
    });
    Channels<K> largest = Channels<K>::Zero();
    for(const Channels<K>& of_block : largest_of_block)
      largest = largest.max(of_block);
    m_elimination.undo_restriction<K>(b);
    for(int c = 0; c < K; ++c)
      m_scale[c] =
        largest[c] > 0 && std::isfinite(largest[c]) ? std::ldexp(1., (std::min)(-std::ilogb(largest[c]), 1000)) : 1.;
    for(Level& level : m_levels)
    {
      const std::size_t size = Lanes<K>::width * level.smoother.rows();
      level.right.assign(size, 0.f);
      level.solution.resize(size);
      level.residual.resize(size);
    }
  }

  // x = V b for K channels that lie together. Returns their products b . x. `before(begin, end)` is called before these
  // rows of b are read, so that they are in the cache. After that b is left as it was.
  template <int K, class Before>
  Channels<K> apply(Untouched_vector<double>& b, Untouched_vector<double>& x, const Before& before)
  {
    if(m_elimination.empty())
      return cycle_from_double<K>(b, x, before);
    for_each_block(m_parallel, std::size_t(m_finest.rows()), block_size, before);
    m_elimination.restrict_to<K>(b);
    const Channels<K> product = cycle_from_double<K>(b, x, [](std::size_t, std::size_t) {}); // P takes nothing from it
    m_elimination.undo_restriction<K>(b);
    m_elimination.prolongate<K>(x);
    return product;
  }

private:
  static constexpr std::size_t block_size = 8192;

  template <int K, class Before>
  Channels<K> cycle_from_double(const Untouched_vector<double>& b, Untouched_vector<double>& x,
                                const Before& before)
  {
    Level& finest = m_levels.front();
    const std::size_t block = finest.smoother.block_size();
    const double* const inverse_diagonal = finest.smoother.inverse_diagonal().data();
    Channels<K> scale, inverse_scale;
    for(int c = 0; c < K; ++c)
    {
      scale[c] = m_scale[c];
      inverse_scale[c] = 1 / m_scale[c];
    }
    const auto enter = [&](std::size_t begin, std::size_t end) {
      before(begin, end);
      const Channels<K> s = scale; // here, no store changes it
      for(std::size_t i = begin; i < end; ++i)
      {
        const double* const from = &b[K * i];
        float* const to = &finest.right[Lanes<K>::width * i];
        for(int c = 0; c < K; ++c)
          to[c] = float(s[c] * (inverse_diagonal[i] * from[c]));
      }
    };
    std::vector<Channels<K> > products((finest.smoother.rows() + block - 1) / block);
    const auto leave = [&](std::size_t begin, std::size_t end) {
      const Channels<K> s = inverse_scale;
      Channels<K> sum = Channels<K>::Zero();
      for(std::size_t i = begin; i < end; ++i)
      {
        const float* const from = &finest.solution[Lanes<K>::width * i];
        double* const to = &x[K * i];
        for(int c = 0; c < K; ++c)
        {
          to[c] = s[c] * from[c];
          sum[c] += b[K * i + c] * to[c];
        }
      }
      products[begin / block] = sum;
    };
    cycle<K>(0, enter, leave);
    Channels<K> sum = Channels<K>::Zero();
    for(const Channels<K>& p : products)
      sum += p;
    return sum;
  }

  // b of a coarser level.
  template <int K>
  struct Restrict
  {
    const Level* finer;
    std::vector<float>* right;

    void operator()(std::size_t begin, std::size_t end) const
    {
      const Sparse_rows<float>& a = finer->restriction;
      for(std::size_t i = begin; i < end; ++i)
      {
        typename Lanes<K>::Value sum = Lanes<K>::Value::Zero();
        for(int e = a.offset[i]; e < a.offset[i + 1]; ++e)
          sum += a.value[e] * Lanes<K>::at(finer->residual, std::size_t(a.column[e]));
        Lanes<K>::at(*right, i) = sum;
      }
    }
  };

  struct Do_nothing
  {
    void operator()(std::size_t, std::size_t) const {}
  };

  // Blocks of the right-hand side are made by `enter` when they are needed, and those of the solution are left to
  // `leave`.
  template <int K, class Enter, class Leave>
  void cycle(std::size_t depth, const Enter& enter, const Leave& leave)
  {
    Level& level = m_levels[depth];
    const Block_smoother& smoother = level.smoother;
    const std::size_t n = smoother.rows();
    if(m_solves_coarsest && depth + 1 == m_levels.size())
    {
      solve_coarsest<K>(level, enter, leave);
      return;
    }
    for_each_block(m_parallel, n, smoother.block_size(), [&](std::size_t begin, std::size_t end) {
      enter(begin, end);
      smoother.smooth_forward<K>(begin, end, level.right, level.solution, level.residual);
    });
    if(depth + 1 < m_levels.size())
    {
      smoother.subtract_outer<K>(level.solution, level.residual, m_parallel);
      Level& coarser = m_levels[depth + 1];
      cycle<K>(depth + 1, Restrict<K>{&level, &coarser.right}, Do_nothing());
      add_prolonged<K>(level, coarser.solution);
    }
    smoother.subtract_outer<K>(level.solution, level.right, m_parallel);
    for_each_block(m_parallel, n, smoother.block_size(), [&](std::size_t begin, std::size_t end) {
      smoother.smooth_backward<K>(begin, end, level.right, level.solution);
      leave(begin, end);
    });
  }

  template <int K>
  void add_prolonged(Level& level, const std::vector<float>& x) const
  {
    const Sparse_rows<float>& a = level.prolongation;
    for_each_block(m_parallel, std::size_t(a.rows()), block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
      {
        typename Lanes<K>::Value sum = Lanes<K>::at(level.solution, i);
        for(int e = a.offset[i]; e < a.offset[i + 1]; ++e)
          sum += a.value[e] * Lanes<K>::at(x, std::size_t(a.column[e]));
        Lanes<K>::at(level.solution, i) = sum;
      }
    });
  }

  Sparse_rows<float> in_single_precision(const Matrix& a) const
  {
    Sparse_rows<float> result;
    result.columns = a.columns;
    result.offset = a.offset;
    result.column.resize(a.column.size());
    result.value.resize(a.value.size());
    for_each_block(m_parallel, a.value.size(), 1 << 16, [&](std::size_t begin, std::size_t end) {
      std::copy(a.column.begin() + begin, a.column.begin() + end, result.column.begin() + begin);
      std::copy(a.value.begin() + begin, a.value.begin() + end, result.value.begin() + begin);
    });
    return result;
  }

  void finish_restriction(const Matrix& r, Level& finer, const Level& coarser) const
  {
    finer.restriction = in_single_precision(r);
    for_each_block(m_parallel, std::size_t(r.rows()), block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
        for(int e = r.offset[i]; e < r.offset[i + 1]; ++e)
          finer.restriction.value[e] = float(r.value[e] * coarser.smoother.inverse_diagonal()[i]
                                             / finer.smoother.inverse_diagonal()[std::size_t(r.column[e])]);
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

  template <int K, class Enter, class Leave>
  void solve_coarsest(Level& level, const Enter& enter, const Leave& leave) const
  {
    constexpr int width = Lanes<K>::width;
    const std::size_t n = level.smoother.rows();
    enter(0, n);
    Eigen::MatrixXd block(n, K);
    for(std::size_t i = 0; i < n; ++i)
      for(int c = 0; c < K; ++c)
        block(i, c) = level.right[width * i + c] / level.smoother.inverse_diagonal()[i];
    m_coarsest.solveInPlace(block);
    for(std::size_t i = 0; i < n; ++i)
      for(int c = 0; c < width; ++c)
        level.solution[width * i + c] = c < K ? float(block(i, c)) : 0.f;
    leave(0, n);
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_AGGREGATION_MULTIGRID_H
