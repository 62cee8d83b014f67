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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_PARALLEL_PARALLEL_BLOCKS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_PARALLEL_PARALLEL_BLOCKS_H

#include <CGAL/Gradient_domain_processing/internal/parallel/tbb_parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Cuts [0, n) into blocks of the given size and calls body(begin, end) for each. The blocks depend on nothing but n and
// the size: what is computed block by block is the same to the bit with any number of threads.
template <class Body>
void for_each_block(bool parallel, std::size_t n, std::size_t size, const Body& body)
{
  const std::size_t number_of_blocks = (n + size - 1) / size;
  const auto run = [&](std::size_t block) { body(block * size, (std::min)(n, (block + 1) * size)); };
#ifdef CGAL_LINKED_WITH_TBB
  if(parallel && number_of_blocks > 1)
  {
    tbb_parallel_for(Loop_range(0, number_of_blocks, 1), [&](const Loop_range& range) {
      for(std::size_t block = range.begin(); block != range.end(); ++block)
        run(block);
    });
    return;
  }
#else
  (void)parallel;
#endif
  for(std::size_t block = 0; block < number_of_blocks; ++block)
    run(block);
}

// The sum of body(begin, end) over all blocks, added in their order.
template <class Sum, class Body>
Sum sum_over_blocks(bool parallel, std::size_t n, std::size_t size, const Sum& zero, const Body& body)
{
  std::vector<Sum> partial((n + size - 1) / size, zero);
  for_each_block(parallel, n, size,
                 [&](std::size_t begin, std::size_t end) { partial[begin / size] = body(begin, end); });
  Sum sum = zero;
  for(const Sum& p : partial)
    sum += p;
  return sum;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_PARALLEL_PARALLEL_BLOCKS_H
