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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_AGGREGATION_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_AGGREGATION_H

#include <CGAL/Gradient_domain_processing/internal/linear_solver/multigrid/Sparse_rows.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Smoothed aggregation (after Vanek, Mandel, Brezina 1996): coarser unknowns are groups of strongly connected finer
// ones; where the mass dominates there are none.

// Strong couplings pull two unknowns together; those of obtuse angles and of the mass push, and are not among them.
inline std::vector<char> strong_couplings(const Sparse_rows<double>& a, double threshold, bool parallel)
{
  const std::vector<double> diagonal = a.diagonal(parallel);
  std::vector<char> is_strong(a.value.size());
  for_each_block(parallel, diagonal.size(), 8192, [&](std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
      for(int e = a.offset[i]; e < a.offset[i + 1]; ++e)
        is_strong[e] =
          a.value[e] < 0
          && a.value[e] * a.value[e] > threshold * threshold * diagonal[i] * diagonal[std::size_t(a.column[e])];
  });
  return is_strong;
}

// Block by block: an unknown whose strong neighbors in the block are all free makes an aggregate with them.
inline int begin_aggregates(const Sparse_rows<double>& a, const std::vector<char>& is_strong, bool parallel,
                            std::vector<int>& aggregate)
{
  constexpr std::size_t block_size = 16384;
  const std::size_t n = std::size_t(a.rows());
  aggregate.assign(n, -1);
  std::vector<int> first(n / block_size + 2, 0); // aggregate of a block
  for_each_block(parallel, n, block_size, [&](std::size_t begin, std::size_t end) {
    const auto for_each_neighbor = [&](std::size_t i, const auto& visit) {
      for(int e = a.offset[i]; e < a.offset[i + 1]; ++e)
        if(is_strong[e] && std::size_t(a.column[e]) >= begin && std::size_t(a.column[e]) < end)
          visit(aggregate[a.column[e]]);
    };
    int count = 0;
    for(std::size_t i = begin; i < end; ++i)
    {
      if(aggregate[i] >= 0)
        continue;
      bool is_free = std::find(is_strong.begin() + a.offset[i], is_strong.begin() + a.offset[i + 1], 1)
                     != is_strong.begin() + a.offset[i + 1];
      for_each_neighbor(i, [&](int aggregate_of_neighbor) { is_free = is_free && aggregate_of_neighbor < 0; });
      if(!is_free)
        continue;
      aggregate[i] = count;
      for_each_neighbor(i, [&](int& aggregate_of_neighbor) { aggregate_of_neighbor = count; });
      ++count;
    }
    first[begin / block_size + 1] = count;
  });
  for(std::size_t block = 1; block < first.size(); ++block)
    first[block] += first[block - 1];
  for_each_block(parallel, n, block_size, [&](std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
      if(aggregate[i] >= 0)
        aggregate[i] += first[begin / block_size];
  });
  return first.back();
}

// Those that are in no aggregate join that of the neighbor they are coupled to most strongly. One without strong
// neighbors stays in none.
inline int aggregate_unknowns(const Sparse_rows<double>& a, const std::vector<char>& is_strong, bool parallel,
                              std::vector<int>& aggregate)
{
  const int count = begin_aggregates(a, is_strong, parallel, aggregate);
  const std::vector<int> begun = aggregate;
  for_each_block(parallel, aggregate.size(), 8192, [&](std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
    {
      double strongest = 0;
      for(int e = a.offset[i]; begun[i] < 0 && e < a.offset[i + 1]; ++e)
        if(is_strong[e] && a.value[e] < strongest && begun[a.column[e]] >= 0)
        {
          strongest = a.value[e];
          aggregate[i] = begun[a.column[e]];
        }
    }
  });
  return count;
}

// P = (I - omega D^-1 A') T: T has a column for every aggregate, A' is the matrix with its weak couplings moved to the
// diagonal D. A' is diagonally dominant, which bounds D^-1 A' by 2 and gives the best omega, 4/3 of the bound's
// inverse.
inline Sparse_rows<double> prolongation(const Sparse_rows<double>& a, double threshold, bool parallel)
{
  const double omega = 2. / 3;
  const std::vector<char> is_strong = strong_couplings(a, threshold, parallel);
  std::vector<int> aggregate;
  const int number_of_aggregates = aggregate_unknowns(a, is_strong, parallel, aggregate);
  return build_rows<double>(parallel, a.rows(), number_of_aggregates, [&](std::size_t i, auto& row) {
    if(aggregate[i] < 0)
      return;
    double filtered = 0, strong = 0;
    for(int e = a.offset[i]; e < a.offset[i + 1]; ++e)
      (is_strong[e] ? strong : filtered) += is_strong[e] ? -a.value[e] : a.value[e];
    filtered = (std::max)(filtered, strong); // obtuse angles at constrained vertices may leave less
    for(int e = a.offset[i]; e < a.offset[i + 1]; ++e)
      if(is_strong[e] && aggregate[a.column[e]] >= 0)
        row.add(aggregate[a.column[e]], -omega * a.value[e] / filtered);
    row.add(aggregate[i], 1 - omega);
  });
}

// P^T A P, a row at a time.
inline Sparse_rows<double> galerkin_product(const Sparse_rows<double>& a, const Sparse_rows<double>& p,
                                            const Sparse_rows<double>& r, bool parallel)
{
  return build_rows<double>(parallel, r.rows(), r.rows(), [&](std::size_t row_index, auto& row) {
    for(int e = r.offset[row_index]; e < r.offset[row_index + 1]; ++e)
    {
      const int i = r.column[e];
      for(int f = a.offset[i]; f < a.offset[i + 1]; ++f)
      {
        const int j = a.column[f];
        const double product = r.value[e] * a.value[f];
        for(int g = p.offset[j]; g < p.offset[j + 1]; ++g)
          row.add(p.column[g], product * p.value[g]);
      }
    }
  });
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_AGGREGATION_H
