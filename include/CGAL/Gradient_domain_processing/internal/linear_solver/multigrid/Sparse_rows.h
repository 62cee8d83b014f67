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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_SPARSE_ROWS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_SPARSE_ROWS_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Lists.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/Untouched_vector.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// A sparse matrix in compressed rows, as plain arrays; entries are first touched by the threads that set them.
template <class Real>
struct Sparse_rows
{
  std::vector<int> offset; // rows + 1
  Untouched_vector<int> column;
  Untouched_vector<Real> value;
  int columns = 0;

  int rows() const { return int(offset.size()) - 1; }

  std::vector<Real> diagonal(bool parallel) const
  {
    std::vector<Real> result(std::size_t(rows()), 0);
    for_each_block(parallel, result.size(), 8192, [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
        for(int e = offset[i]; e < offset[i + 1]; ++e)
          if(std::size_t(column[e]) == i)
            result[i] += value[e];
    });
    return result;
  }
};

template <class Real>
Sparse_rows<Real> transpose(const Sparse_rows<Real>& a, bool parallel)
{
  Untouched_vector<int> row_of(a.column.size());
  for_each_block(parallel, std::size_t(a.rows()), 8192, [&](std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
      std::fill(row_of.begin() + a.offset[i], row_of.begin() + a.offset[i + 1], int(i));
  });
  Lists entries =
    numbers_by_key(parallel, a.columns, a.column.size(), [&](std::size_t entry) { return a.column[entry]; });
  Sparse_rows<Real> t;
  t.columns = a.rows();
  t.offset.swap(entries.offsets);
  t.column.resize(a.column.size());
  t.value.resize(a.column.size());
  for_each_block(parallel, a.column.size(), 1 << 16, [&](std::size_t begin, std::size_t end) {
    for(std::size_t at = begin; at < end; ++at)
    {
      t.column[at] = row_of[std::size_t(entries.items[at])];
      t.value[at] = a.value[std::size_t(entries.items[at])];
    }
  });
  return t;
}

// Consecutive rows under construction. Entries of a column are added up.
template <class Real>
class Row_builder
{
  std::vector<int> m_place; // by column: its place if it is in the last row, else something else
  std::vector<int> m_column;
  std::vector<Real> m_value;
  std::vector<int> m_end;
  int m_begin = 0;

public:
  explicit Row_builder(int columns) : m_place(columns, -1) {}

  void add(int column, Real value)
  {
    const int place = m_place[column];
    if(place >= m_begin)
      m_value[place] += value;
    else
    {
      m_place[column] = int(m_column.size());
      m_column.push_back(column);
      m_value.push_back(value);
    }
  }

  void close_row()
  {
    m_begin = int(m_column.size());
    m_end.push_back(m_begin);
  }

  void close() { std::vector<int>().swap(m_place); }

  int size() const { return m_begin; }

  // Puts its rows into a matrix, the first at `begin`.
  void copy_to(Sparse_rows<Real>& matrix, std::size_t first_row, int begin) const
  {
    std::copy(m_column.begin(), m_column.end(), matrix.column.begin() + begin);
    std::copy(m_value.begin(), m_value.end(), matrix.value.begin() + begin);
    for(std::size_t i = 0; i < m_end.size(); ++i)
      matrix.offset[first_row + i + 1] = begin + m_end[i];
  }
};

// The matrix whose row i is what fill(i, row) adds to it.
template <class Real, class Fill>
Sparse_rows<Real> build_rows(bool parallel, int rows, int columns, const Fill& fill)
{
  // few blocks, as each has a place for every column
  const std::size_t block_size = (std::max)(4096, rows / 32 + 1);
  std::vector<Row_builder<Real> > blocks((rows + block_size - 1) / block_size, Row_builder<Real>(0));
  for_each_block(parallel, rows, block_size, [&](std::size_t begin, std::size_t end) {
    Row_builder<Real> block(columns);
    for(std::size_t i = begin; i < end; ++i)
    {
      fill(i, block);
      block.close_row();
    }
    block.close();
    blocks[begin / block_size] = std::move(block);
  });

  Sparse_rows<Real> matrix;
  matrix.columns = columns;
  matrix.offset.assign(rows + 1, 0);
  std::vector<int> begins(1, 0);
  for(const Row_builder<Real>& block : blocks)
    begins.push_back(begins.back() + block.size());
  matrix.column.resize(std::size_t(begins.back()));
  matrix.value.resize(std::size_t(begins.back()));
  for_each_block(parallel, blocks.size(), 1, [&](std::size_t b, std::size_t) {
    blocks[b].copy_to(matrix, b * block_size, begins[b]);
    blocks[b] = Row_builder<Real>(0);
  });
  return matrix;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_SPARSE_ROWS_H
