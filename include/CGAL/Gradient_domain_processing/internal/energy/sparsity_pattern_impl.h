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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_SPARSITY_PATTERN_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_SPARSITY_PATTERN_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/energy/sparsity_pattern.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE Lists sparsity_pattern(const Lists& rings, const Degrees_of_freedom& dofs, bool lower_only,
                                       bool parallel)
{
  const int n = dofs.size();
  const auto is_in = [&](int row, int column) { return row > column || (row >= 0 && !lower_only); };
  Lists pattern;
  pattern.offsets.assign(n + 1, 0);
  for_each_degree_of_freedom(parallel, dofs, [&](int v, int j) {
    pattern.offsets[j + 1] = 1 + int(std::count_if(rings.begin(v), rings.end(v), [&](int w) {
      return is_in(dofs.of_vertex[w], j);
    }));
  });
  for(int j = 0; j < n; ++j)
    pattern.offsets[j + 1] += pattern.offsets[j];
  pattern.items.resize(pattern.offsets[n]);
  for_each_degree_of_freedom(parallel, dofs, [&](int v, int j) {
    int* const first = pattern.items.data() + pattern.offsets[j];
    int* last = first;
    *last++ = j;
    for(const int* w = rings.begin(v); w != rings.end(v); ++w)
      if(is_in(dofs.of_vertex[*w], j))
        *last++ = dofs.of_vertex[*w];
    std::sort(first, last);
  });
  return pattern;
}

CGAL_GDP_INLINE void set_pattern(const Lists& pattern, bool parallel, Sparse_matrix& matrix)
{
  matrix.resize(pattern.size(), pattern.size());
  matrix.resizeNonZeros(pattern.offsets.back());
  std::copy(pattern.offsets.begin(), pattern.offsets.end(), matrix.outerIndexPtr());
  // most of it is the first touch of memory
  for_each_block(parallel, pattern.items.size(), 1 << 16, [&](std::size_t begin, std::size_t end) {
    std::copy(pattern.items.data() + begin, pattern.items.data() + end, matrix.innerIndexPtr() + begin);
  });
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_SPARSITY_PATTERN_IMPL_H
