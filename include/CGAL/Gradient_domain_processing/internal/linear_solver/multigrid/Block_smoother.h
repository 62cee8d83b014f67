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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_BLOCK_SMOOTHER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_BLOCK_SMOOTHER_H

#include <CGAL/Gradient_domain_processing/internal/linear_solver/multigrid/Lanes.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/multigrid/Sparse_rows.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/Untouched_vector.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Gauss-Seidel within blocks of rows, which are smoothed side by side. What a row of a block has in common with other
// blocks is added to its diagonal: then it converges for every positive definite matrix (Baker, Falgout, Kolev, Yang
// 2011).
//
// Rows are divided by that diagonal D: right-hand sides and residuals are so, too, and are about as large as the
// solution, which single precision can hold whatever the unit of the matrix.
class Block_smoother
{
  std::size_t m_block_size = 0;
  std::vector<double> m_inverse_diagonal; // of D

  // In every row the entries within its block, those before the diagonal, then those after it.
  std::vector<int> m_offset, m_middle;
  Untouched_vector<int> m_column;
  Untouched_vector<float> m_value;

  // The others, of rows that have any; on the diagonal stands, with a minus, what was added to it.
  std::vector<int> m_outer_row, m_outer_offset, m_outer_column;
  std::vector<float> m_outer_value;
  std::vector<int> m_first_outer_row; // of every block

public:
  std::size_t rows() const { return m_inverse_diagonal.size(); }
  std::size_t block_size() const { return m_block_size; }
  const std::vector<double>& inverse_diagonal() const { return m_inverse_diagonal; }

  // Returns whether the diagonal is positive.
  bool prepare(const Sparse_rows<double>& a, bool parallel)
  {
    const std::size_t n = std::size_t(a.rows());
    // work for many, in their caches
    m_block_size = (std::min)((std::max)(n / 64, std::size_t(1024)), std::size_t(8192));
    if(!read_diagonal(a, parallel))
      return false;
    m_first_outer_row.assign(1, 0);
    m_outer_offset.assign(1, 0);
    for(std::size_t i = 0; i < n; ++i)
    {
      const int outer = a.offset[i + 1] - a.offset[i] - m_offset[i + 1];
      m_middle[i] += m_offset[i];
      m_offset[i + 1] += m_offset[i] - 1; // but for the diagonal
      if(outer > 0)
      {
        m_outer_row.push_back(int(i));
        m_outer_offset.push_back(m_outer_offset.back() + outer + 1);
      }
      if(i + 1 == n || (i + 1) % m_block_size == 0)
        m_first_outer_row.push_back(int(m_outer_row.size()));
    }
    m_column.resize(std::size_t(m_offset[n]));
    m_value.resize(std::size_t(m_offset[n]));
    m_outer_column.resize(std::size_t(m_outer_offset.back()));
    m_outer_value.resize(std::size_t(m_outer_offset.back()));
    for_each_block(parallel, n, m_block_size, [&](std::size_t begin, std::size_t end) { fill_block(a, begin, end); });
    return true;
  }

  // One sweep over a block from x = 0, to which what comes later in the block does not contribute; and the residual,
  // but for what other blocks have to do with it.
  template <int K>
  void smooth_forward(std::size_t begin, std::size_t end, const std::vector<float>& b, std::vector<float>& x,
                      std::vector<float>& r) const
  {
    typedef Lanes<K> L;
    for(std::size_t i = begin; i < end; ++i)
    {
      typename L::Value sum = L::at(b, i);
      for(int e = m_offset[i]; e < m_middle[i]; ++e)
        sum -= m_value[e] * L::at(x, m_column[e]);
      L::at(x, i) = sum;
    }
    for(std::size_t i = begin; i < end; ++i)
    {
      typename L::Value sum = L::Value::Zero();
      for(int e = m_middle[i]; e < m_offset[i + 1]; ++e)
        sum -= m_value[e] * L::at(x, m_column[e]);
      L::at(r, i) = sum;
    }
  }

  // One sweep over a block in the opposite order, the adjoint of the other, once subtract_outer() has been called with
  // b and x.
  template <int K>
  void smooth_backward(std::size_t begin, std::size_t end, const std::vector<float>& b, std::vector<float>& x) const
  {
    typedef Lanes<K> L;
    for(std::size_t i = end; i-- > begin; )
    {
      typename L::Value sum = L::at(b, i);
      for(int e = m_offset[i]; e < m_offset[i + 1]; ++e)
        sum -= m_value[e] * L::at(x, m_column[e]);
      L::at(x, i) = sum;
    }
  }

  // r -= E x, where E is what blocks have to do with each other.
  template <int K>
  void subtract_outer(const std::vector<float>& x, std::vector<float>& r, bool parallel) const
  {
    typedef Lanes<K> L;
    if(m_outer_row.empty())
      return;
    for_each_block(parallel, m_first_outer_row.size() - 1, 8, [&](std::size_t first, std::size_t last) {
      for(int k = m_first_outer_row[first]; k < m_first_outer_row[last]; ++k)
      {
        typename L::Value sum = L::at(r, std::size_t(m_outer_row[k]));
        for(int e = m_outer_offset[k]; e < m_outer_offset[k + 1]; ++e)
          sum -= m_outer_value[e] * L::at(x, m_outer_column[e]);
        L::at(r, std::size_t(m_outer_row[k])) = sum;
      }
    });
  }

private:
  // And how many entries a row has in its block, in m_offset, and before its diagonal, in m_middle.
  bool read_diagonal(const Sparse_rows<double>& a, bool parallel)
  {
    const std::size_t n = std::size_t(a.rows());
    m_inverse_diagonal.resize(n);
    m_middle.resize(n);
    m_offset.resize(n + 1);
    m_offset[0] = 0;
    std::vector<char> is_positive(n);
    for_each_block(parallel, n, m_block_size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
      {
        double own = 0, others = 0;
        int before = 0, inner = 0;
        for(int e = a.offset[i]; e < a.offset[i + 1]; ++e)
        {
          const std::size_t j = std::size_t(a.column[e]);
          const bool is_inner = j >= begin && j < end;
          inner += is_inner;
          before += is_inner && j < i;
          if(j == i)
            own = a.value[e];
          else if(!is_inner)
            others += std::abs(a.value[e]);
        }
        is_positive[i] = own > 0;
        m_inverse_diagonal[i] = 1 / (own + others);
        m_middle[i] = before;
        m_offset[i + 1] = inner;
      }
    });
    return std::find(is_positive.begin(), is_positive.end(), 0) == is_positive.end();
  }

  void fill_block(const Sparse_rows<double>& a, std::size_t begin, std::size_t end)
  {
    int outer_row = m_first_outer_row[begin / m_block_size];
    for(std::size_t i = begin; i < end; ++i)
    {
      int before = m_offset[i], after = m_middle[i], outer = m_outer_offset[outer_row];
      double others = 0;
      for(int e = a.offset[i]; e < a.offset[i + 1]; ++e)
      {
        const std::size_t j = std::size_t(a.column[e]);
        const float value = float(a.value[e] * m_inverse_diagonal[i]);
        if(j == i)
          continue;
        if(j < begin || j >= end)
        {
          others += std::abs(a.value[e]);
          m_outer_column[outer] = int(j);
          m_outer_value[outer++] = value;
          continue;
        }
        int& at = j < i ? before : after;
        m_column[at] = int(j);
        m_value[at++] = value;
      }
      if(outer > m_outer_offset[outer_row])
      {
        m_outer_column[outer] = int(i);
        m_outer_value[outer] = float(-others * m_inverse_diagonal[i]);
        ++outer_row;
      }
    }
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_BLOCK_SMOOTHER_H
