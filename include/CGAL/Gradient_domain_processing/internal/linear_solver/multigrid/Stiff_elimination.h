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
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// A sliver binds a degree of freedom to its neighbors: a cap its apex to the line between the ends of its base, a
// needle two vertices to each other. The large number in the matrix that does so has a small one hidden behind it,
// which neither a smoother that looks at one row at a time finds, nor aggregates, which know constants only. Those that
// are bound are eliminated, exactly: with D their diagonal, A^-1 = D^-1 + P S^-1 P^T, where P gives them what their
// neighbors ask for, and S = P^T A P is as if the sliver had never been. They keep their places, in which the remainder
// has D alone, so that the work is theirs only, not the mesh's.
class Stiff_elimination
{
  typedef Sparse_rows<double> Matrix;
  typedef std::vector<std::pair<int, double> > Row;

  static constexpr int max_number_of_rounds = 12; // slivers that hang together take several
  static constexpr int max_row_length = 32;       // its neighbors become neighbors of each other

  std::vector<int> m_eliminated;                // in this order
  std::vector<int> m_offset, m_neighbor;        // of them
  std::vector<double> m_share;                  // of a neighbor: its entry in P
  std::vector<int> m_touched;                   // all neighbors, once
  std::vector<double> m_kept;                   // what they had before restrict_to()

public:
  bool empty() const { return m_eliminated.empty(); }

  // Makes the remainder of a matrix, unless nothing is eliminated, as in one that is not positive on its diagonal.
  void eliminate(const Matrix& matrix, bool parallel, Matrix& remainder)
  {
    *this = Stiff_elimination();
    std::vector<double> diagonal = matrix.diagonal(parallel);
    if(!std::all_of(diagonal.begin(), diagonal.end(), [](double d) { return d > 0; }))
      return;
    Remainder rows(matrix, diagonal);
    m_offset.assign(1, 0);
    std::vector<int> candidates = rows.bound(parallel);
    for(int round = 0; round < max_number_of_rounds && !candidates.empty(); ++round)
    {
      const std::size_t first = m_eliminated.size();
      choose(rows, candidates);
      std::vector<int> changed;
      for(std::size_t k = first; k < m_eliminated.size(); ++k)
      {
        const Row row = rows.take(m_eliminated[k]);
        for(const std::pair<int, double>& entry : row)
        {
          m_neighbor.push_back(entry.first);
          m_share.push_back(-entry.second / diagonal[m_eliminated[k]]);
          changed.push_back(entry.first);
        }
        m_offset.push_back(int(m_neighbor.size()));
      }
      candidates = rows.bound_about(changed);
    }
    if(empty())
      return;
    m_touched = m_neighbor;
    std::sort(m_touched.begin(), m_touched.end());
    m_touched.erase(std::unique(m_touched.begin(), m_touched.end()), m_touched.end());
    remainder = rows.matrix(parallel);
  }

  // b = P^T b and, where it was eliminated, b. For K channels that lie together.
  template <int K>
  void restrict_to(Untouched_vector<double>& b)
  {
    m_kept.resize(K * m_touched.size());
    for(std::size_t k = 0; k < m_touched.size(); ++k)
      std::copy_n(&b[K * std::size_t(m_touched[k])], K, &m_kept[K * k]);
    for(std::size_t k = 0; k < m_eliminated.size(); ++k)
      for(int e = m_offset[k]; e < m_offset[k + 1]; ++e)
        for(std::size_t c = 0; c < K; ++c)
          b[K * std::size_t(m_neighbor[e]) + c] += m_share[e] * b[K * std::size_t(m_eliminated[k]) + c];
  }

  // b as it was.
  template <int K>
  void undo_restriction(Untouched_vector<double>& b) const
  {
    for(std::size_t k = 0; k < m_touched.size(); ++k)
      std::copy_n(&m_kept[K * k], K, &b[K * std::size_t(m_touched[k])]);
  }

  // x = x + P x, where x has D^-1 b at what was eliminated.
  template <int K>
  void prolongate(Untouched_vector<double>& x) const
  {
    for(std::size_t k = m_eliminated.size(); k-- > 0; )
      for(int e = m_offset[k]; e < m_offset[k + 1]; ++e)
        for(std::size_t c = 0; c < K; ++c)
          x[K * std::size_t(m_eliminated[k]) + c] += m_share[e] * x[K * std::size_t(m_neighbor[e]) + c];
  }

private:
  // The matrix with some rows replaced.
  class Remainder
  {
    const Matrix& m_matrix;
    std::vector<double>& m_diagonal;
    std::vector<int> m_place; // of a row that was replaced, in m_rows
    std::vector<Row> m_rows;  // without the diagonal

  public:
    Remainder(const Matrix& matrix, std::vector<double>& diagonal)
      : m_matrix(matrix)
      , m_diagonal(diagonal)
      , m_place(diagonal.size(), -1)
    {
    }

    std::size_t size() const { return m_place.size(); }
    double diagonal(int i) const { return m_diagonal[i]; }

    template <class Visit>
    void for_each_neighbor(int i, const Visit& visit) const
    {
      if(m_place[i] >= 0)
        for(const std::pair<int, double>& entry : m_rows[m_place[i]])
          visit(entry.first, entry.second);
      else
        for(int e = m_matrix.offset[i]; e < m_matrix.offset[i + 1]; ++e)
          if(m_matrix.column[e] != i)
            visit(m_matrix.column[e], m_matrix.value[e]);
    }

    // The squared couplings of a row, relative to the diagonals, sum up to a sixth in a mesh of good triangles, to a
    // half where all couplings are along lines, and to two at a sliver.
    bool is_bound(int i) const
    {
      const double bound = 0.75;
      double sum = 0;
      int length = 1;
      for_each_neighbor(i, [&](int j, double value) {
        sum += (value / m_diagonal[i]) * (value / m_diagonal[j]);
        ++length;
      });
      return sum > bound && length <= max_row_length;
    }

    std::vector<int> bound(bool parallel) const
    {
      std::vector<char> is(size());
      for_each_block(parallel, is.size(), 8192, [&](std::size_t begin, std::size_t end) {
        for(std::size_t i = begin; i < end; ++i)
          is[i] = is_bound(int(i));
      });
      std::vector<int> result;
      for(std::size_t i = 0; i < is.size(); ++i)
        if(is[i])
          result.push_back(int(i));
      return result;
    }

    // Among these rows and their neighbors.
    std::vector<int> bound_about(std::vector<int> rows) const
    {
      const std::size_t size = rows.size();
      for(std::size_t k = 0; k < size; ++k)
        for_each_neighbor(rows[k], [&](int j, double) { rows.push_back(j); });
      std::sort(rows.begin(), rows.end());
      rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
      rows.erase(std::remove_if(rows.begin(), rows.end(), [&](int i) { return !is_bound(i); }), rows.end());
      return rows;
    }

    // Eliminates a row, which is returned.
    Row take(int k)
    {
      Row row;
      for_each_neighbor(k, [&](int j, double value) { row.emplace_back(j, value); });
      for(const std::pair<int, double>& to : row)
      {
        Row& changed = replaced(to.first);
        changed.erase(std::find_if(changed.begin(), changed.end(), [&](const auto& e) { return e.first == k; }));
        for(const std::pair<int, double>& from : row)
        {
          const double product = to.second * from.second / m_diagonal[k];
          if(from.first == to.first)
          {
            m_diagonal[to.first] -= product;
            continue;
          }
          const auto at = std::find_if(changed.begin(), changed.end(),
                                       [&](const auto& entry) { return entry.first == from.first; });
          if(at == changed.end())
            changed.emplace_back(from.first, -product);
          else
            at->second -= product;
        }
      }
      replaced(k).clear();
      return row;
    }

    Matrix matrix(bool parallel) const
    {
      Matrix result;
      result.columns = m_matrix.columns;
      result.offset.reserve(size() + 1);
      result.offset.push_back(0);
      for(std::size_t i = 0; i < size(); ++i)
        result.offset.push_back(result.offset.back()
                                + (m_place[i] < 0 ? m_matrix.offset[i + 1] - m_matrix.offset[i]
                                                  : int(m_rows[m_place[i]].size()) + 1));
      result.column.resize(std::size_t(result.offset.back()));
      result.value.resize(std::size_t(result.offset.back()));
      for_each_block(parallel, size(), 8192, [&](std::size_t begin, std::size_t end) {
        for(std::size_t i = begin; i < end; ++i)
        {
          int at = result.offset[i];
          const auto put = [&](int j, double value) {
            result.column[at] = j;
            result.value[at++] = value;
          };
          put(int(i), m_diagonal[i]);
          for_each_neighbor(int(i), put);
        }
      });
      return result;
    }

  private:
    Row& replaced(int i)
    {
      if(m_place[i] < 0)
      {
        Row row;
        for_each_neighbor(i, [&](int j, double value) { row.emplace_back(j, value); });
        m_place[i] = int(m_rows.size());
        m_rows.push_back(std::move(row));
      }
      return m_rows[m_place[i]];
    }
  };

  // Some of the candidates that are no neighbors, those with the largest diagonals first: apices of caps, not the ends
  // of their bases.
  void choose(const Remainder& rows, std::vector<int> candidates)
  {
    std::stable_sort(candidates.begin(), candidates.end(),
                     [&](int i, int j) { return rows.diagonal(i) > rows.diagonal(j); });
    std::vector<char> is_excluded(rows.size(), 0);
    for(int k : candidates)
    {
      if(is_excluded[k])
        continue; // a neighbor was chosen
      m_eliminated.push_back(k);
      rows.for_each_neighbor(k, [&](int j, double) { is_excluded[j] = 1; });
    }
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_STIFF_ELIMINATION_H
