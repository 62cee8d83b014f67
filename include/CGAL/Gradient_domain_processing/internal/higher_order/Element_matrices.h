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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_ELEMENT_MATRICES_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_ELEMENT_MATRICES_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/Untouched_vector.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_for.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Small dense symmetric matrices, each on a few degrees of freedom, which may repeat; together they make a sparse one.
// Every element is written on its own, and entries are added up in the order of the elements: the same bits on any
// number of threads.
class Element_matrices
{
  Lists m_indices;
  std::vector<std::size_t> m_offsets; // of the elements' values: rows of the lower triangle, end to end
  Untouched_vector<double> m_values;

  static std::size_t packed(int row, int column)
  {
    const std::size_t low = std::size_t((std::min)(row, column)), high = std::size_t((std::max)(row, column));
    return high * (high + 1) / 2 + low;
  }

public:
  // The degrees of freedom of every element.
  explicit Element_matrices(Lists indices) : m_indices(std::move(indices))
  {
    m_offsets.assign(1, 0);
    m_offsets.reserve(m_indices.offsets.size());
    for(int e = 0; e < m_indices.size(); ++e)
      m_offsets.push_back(m_offsets.back() + packed(m_indices.size(e), 0));
    m_values.resize(m_offsets.back());
  }

  int size() const { return m_indices.size(); }
  int size(int e) const { return m_indices.size(e); }
  const int* indices(int e) const { return m_indices.begin(e); }

  double& value(int e, int row, int column) { return m_values[m_offsets[std::size_t(e)] + packed(row, column)]; }
  double value(int e, int row, int column) const { return m_values[m_offsets[std::size_t(e)] + packed(row, column)]; }

  // weight * v v^T
  void set_rank_one(int e, double weight, const double* v)
  {
    for(int row = 0; row < size(e); ++row)
      for(int column = 0; column <= row; ++column)
        value(e, row, column) = weight * v[row] * v[column];
  }

  // Stored as a whole, n x n.
  Eigen::SparseMatrix<double> sum(int n, bool parallel) const
  {
    const Lists places = numbers_by_key(parallel, n, m_indices.items.size(), // of every degree of freedom
                                        [&](std::size_t at) { return m_indices.items[at]; });
    std::vector<int> element_of(m_indices.items.size());
    for(int e = 0; e < size(); ++e)
      std::fill(element_of.begin() + m_indices.offsets[std::size_t(e)],
                element_of.begin() + m_indices.offsets[std::size_t(e) + 1], e);

    typedef std::pair<int, double> Entry;
    const auto column = [&](int j) {
      std::vector<Entry> entries;
      for(const int* at = places.begin(j); at != places.end(j); ++at)
      {
        const int e = element_of[std::size_t(*at)], k = *at - m_indices.offsets[std::size_t(e)];
        for(int i = 0; i < size(e); ++i)
          entries.emplace_back(indices(e)[i], value(e, i, k));
      }
      std::stable_sort(entries.begin(), entries.end(),
                       [](const Entry& a, const Entry& b) { return a.first < b.first; });
      std::size_t last = 0; // of those merged
      for(std::size_t i = 1; i < entries.size(); ++i)
        if(entries[i].first == entries[last].first)
          entries[last].second += entries[i].second;
        else
          entries[++last] = entries[i];
      if(!entries.empty())
        entries.resize(last + 1);
      return entries;
    };

    Eigen::SparseMatrix<double> matrix(n, n);
    int* const offsets = matrix.outerIndexPtr();
    parallel_for(parallel, std::size_t(n), [&](std::size_t j) { offsets[j + 1] = int(column(int(j)).size()); });
    for(int j = 0; j < n; ++j)
      offsets[j + 1] += offsets[j];
    matrix.resizeNonZeros(offsets[n]);
    parallel_for(parallel, std::size_t(n), [&](std::size_t j) {
      int at = offsets[j];
      for(const Entry& entry : column(int(j)))
      {
        matrix.innerIndexPtr()[at] = entry.first;
        matrix.valuePtr()[at++] = entry.second;
      }
    });
    return matrix;
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_ELEMENT_MATRICES_H
