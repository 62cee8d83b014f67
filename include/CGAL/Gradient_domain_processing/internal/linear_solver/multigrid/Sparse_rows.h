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

#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// A sparse matrix in compressed rows, as plain arrays.
template <class Real>
struct Sparse_rows
{
  std::vector<int> offset; // rows + 1
  std::vector<int> column;
  std::vector<Real> value;
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
Sparse_rows<Real> transpose(const Sparse_rows<Real>& a)
{
  Sparse_rows<Real> t;
  t.columns = a.rows();
  t.offset.assign(a.columns + 1, 0);
  for(int j : a.column)
    ++t.offset[j + 1];
  for(int j = 0; j < a.columns; ++j)
    t.offset[j + 1] += t.offset[j];
  t.column.resize(a.column.size());
  t.value.resize(a.value.size());
  std::vector<int> next(t.offset.begin(), t.offset.end() - 1);
  for(int i = 0; i < a.rows(); ++i)
    for(int e = a.offset[i]; e < a.offset[i + 1]; ++e)
    {
      const int at = next[a.column[e]]++;
      t.column[at] = i;
      t.value[at] = a.value[e];
    }
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

  // Puts its rows into a matrix whose offsets are those of the rows.
  void copy_to(Sparse_rows<Real>& matrix, std::size_t first_row) const
  {
    const int begin = matrix.offset[first_row];
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
  int size = 0;
  for(std::size_t b = 0; b < blocks.size(); ++b)
  {
    matrix.offset[b * block_size] = size;
    size += blocks[b].size();
  }
  matrix.column.resize(size);
  matrix.value.resize(size);
  for(std::size_t b = 0; b < blocks.size(); ++b)
  {
    blocks[b].copy_to(matrix, b * block_size);
    blocks[b] = Row_builder<Real>(0);
  }
  return matrix;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_SPARSE_ROWS_H
