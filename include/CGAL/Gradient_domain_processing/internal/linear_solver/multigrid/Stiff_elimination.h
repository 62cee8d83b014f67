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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_STIFF_ELIMINATION_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_STIFF_ELIMINATION_H

#include <CGAL/Gradient_domain_processing/internal/linear_solver/multigrid/Sparse_rows.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// A sliver binds a degree of freedom to its neighbors: a cap its apex to the line between the ends of its base, a
// needle two vertices to each other. The large number in the matrix that does so has a small one hidden behind it,
// which neither a smoother that looks at one row at a time finds, nor aggregates, which know constants only. Those that
// are bound are eliminated, exactly, some that are no neighbors at a time: with D their diagonal, A^-1 = D^-1 + P S^-1
// P^T, where P gives them what their neighbors ask for, and S = P^T A P is as if the sliver had never been.
template <class Real>
class Stiff_elimination
{
  typedef Sparse_rows<Real> Matrix;

  std::vector<int> m_eliminated;
  std::vector<Real> m_inverse_diagonal; // of them
  Matrix m_prolongation, m_restriction;

public:
  int rows() const { return m_prolongation.rows(); }

  // Returns whether there are any; then S is the remainder. In a matrix that is not positive on its diagonal there are
  // none.
  bool eliminate(const Matrix& matrix, bool parallel, Matrix& remainder)
  {
    const std::vector<Real> diagonal = matrix.diagonal();
    if(std::all_of(diagonal.begin(), diagonal.end(), [](Real d) { return d > 0; }))
      choose(matrix, diagonal, parallel);
    if(m_eliminated.empty())
      return false;

    std::vector<char> is_eliminated(diagonal.size(), 0);
    for(int k : m_eliminated)
    {
      is_eliminated[k] = 1;
      m_inverse_diagonal.push_back(1 / diagonal[k]);
    }
    std::vector<int> number(diagonal.size());
    int count = 0;
    for(std::size_t i = 0; i < number.size(); ++i)
      number[i] = is_eliminated[i] ? -1 : count++;
    m_prolongation = build_rows<Real>(parallel, matrix.rows(), count, [&](std::size_t i, auto& row) {
      if(!is_eliminated[i])
        row.add(number[i], 1);
      else
        for(int e = matrix.offset[i]; e < matrix.offset[i + 1]; ++e)
          if(matrix.column[e] != int(i))
            row.add(number[matrix.column[e]], -matrix.value[e] / diagonal[i]);
    });
    m_restriction = transpose(m_prolongation);
    remainder = reduced(matrix, is_eliminated, number, count, parallel);
    return true;
  }

  // coarse = P^T b
  template <int K, class B>
  void restrict_to(const B& b, std::vector<Real>& coarse, bool parallel) const
  {
    coarse.resize(K * std::size_t(m_restriction.rows()));
    m_restriction.template multiply<K>(b, coarse, parallel);
  }

  // x = D^-1 b + P coarse
  template <int K, class B, class X>
  void prolongate(const B& b, const std::vector<Real>& coarse, X& x, bool parallel) const
  {
    m_prolongation.template multiply<K>(coarse, x, parallel);
    for(std::size_t k = 0; k < m_eliminated.size(); ++k)
      for(std::size_t c = 0; c < K; ++c)
        x[K * std::size_t(m_eliminated[k]) + c] +=
          m_inverse_diagonal[k] * Real(b[K * std::size_t(m_eliminated[k]) + c]);
  }

private:
  // The squared couplings of a row, relative to the diagonals, sum up to a sixth in a mesh of good triangles, to a half
  // where all couplings are along lines, and to two at a sliver.
  void choose(const Matrix& a, const std::vector<Real>& diagonal, bool parallel)
  {
    const Real bound = Real(0.75);
    const int max_row_length = 32; // its neighbors become neighbors of each other
    std::vector<char> is_bound(diagonal.size());
    for_each_block(parallel, diagonal.size(), 8192, [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
      {
        Real sum = 0;
        for(int e = a.offset[i]; e < a.offset[i + 1]; ++e)
          if(a.column[e] != int(i))
            sum += (a.value[e] / diagonal[i]) * (a.value[e] / diagonal[a.column[e]]);
        is_bound[i] = sum > bound && a.offset[i + 1] - a.offset[i] <= max_row_length;
      }
    });

    // Those with the largest diagonals come first: apices of caps, not the ends of their bases.
    std::vector<int> candidates;
    for(std::size_t i = 0; i < diagonal.size(); ++i)
      if(is_bound[i])
        candidates.push_back(int(i));
    std::stable_sort(candidates.begin(), candidates.end(), [&](int i, int j) { return diagonal[i] > diagonal[j]; });
    for(int k : candidates)
    {
      if(!is_bound[k])
        continue; // a neighbor was chosen
      m_eliminated.push_back(k);
      for(int e = a.offset[k]; e < a.offset[k + 1]; ++e)
        is_bound[a.column[e]] = 0;
    }
    std::sort(m_eliminated.begin(), m_eliminated.end());
  }

  // S: every eliminated neighbor hands on what it is bound to.
  Matrix reduced(const Matrix& a, const std::vector<char>& is_eliminated, const std::vector<int>& number, int count,
                 bool parallel) const
  {
    std::vector<int> kept(count);
    for(std::size_t i = 0; i < number.size(); ++i)
      if(number[i] >= 0)
        kept[number[i]] = int(i);
    return build_rows<Real>(parallel, count, count, [&](std::size_t row_index, auto& row) {
      const int i = kept[row_index];
      for(int e = a.offset[i]; e < a.offset[i + 1]; ++e)
      {
        const int k = a.column[e];
        if(!is_eliminated[k])
          row.add(number[k], a.value[e]);
        else
          for(int f = m_prolongation.offset[k]; f < m_prolongation.offset[k + 1]; ++f)
            row.add(m_prolongation.column[f], a.value[e] * m_prolongation.value[f]);
      }
    });
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_STIFF_ELIMINATION_H
