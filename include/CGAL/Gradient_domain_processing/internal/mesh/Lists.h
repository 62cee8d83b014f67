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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_LISTS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_LISTS_H

#include <CGAL/Gradient_domain_processing/internal/parallel/Untouched_vector.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// A list of lists of numbers, end to end.
struct Lists
{
  std::vector<int> offsets; // size + 1
  std::vector<int> items;

  int size() const { return static_cast<int>(offsets.size()) - 1; }
  const int* begin(int i) const { return items.data() + offsets[std::size_t(i)]; }
  const int* end(int i) const { return items.data() + offsets[std::size_t(i) + 1]; }
  int size(int i) const { return offsets[std::size_t(i) + 1] - offsets[std::size_t(i)]; }
};

// The numbers below n of every key, in increasing order: key(i) is below number_of_keys. A counting sort of two steps,
// into buckets of consecutive keys, by blocks of numbers, and within the buckets.
template <class Key>
Lists numbers_by_key(bool parallel, int number_of_keys, std::size_t n, const Key& key)
{
  constexpr std::size_t block_size = 1 << 16;
  const std::size_t number_of_blocks = n / block_size + 1, number_of_buckets = number_of_blocks > 1 ? 256 : 1;
  const int width = number_of_keys / int(number_of_buckets) + 1; // of a bucket
  std::vector<int> places(number_of_blocks * number_of_buckets, 0);
  for_each_block(parallel, n, block_size, [&](std::size_t begin, std::size_t end) {
    int* const count = &places[begin / block_size * number_of_buckets];
    for(std::size_t i = begin; i < end; ++i)
      ++count[key(i) / width];
  });
  std::vector<int> bucket_begins(1, 0);
  int place = 0;
  for(std::size_t bucket = 0; bucket < number_of_buckets; ++bucket)
  {
    for(std::size_t block = 0; block < number_of_blocks; ++block)
      place += std::exchange(places[block * number_of_buckets + bucket], place);
    bucket_begins.push_back(place);
  }
  Untouched_vector<int> by_bucket(n);
  for_each_block(parallel, n, block_size, [&](std::size_t begin, std::size_t end) {
    int* const next = &places[begin / block_size * number_of_buckets];
    for(std::size_t i = begin; i < end; ++i)
      by_bucket[std::size_t(next[key(i) / width]++)] = int(i);
  });

  Lists lists;
  lists.offsets.assign(std::size_t(number_of_keys) + 1, 0);
  lists.items.resize(n);
  for_each_block(parallel, number_of_buckets, 1, [&](std::size_t bucket, std::size_t) {
    const int first_key = (std::min)(int(bucket) * width, number_of_keys);
    std::vector<int> next(std::size_t((std::min)(width, number_of_keys - first_key)) + 1, 0);
    const int begin = bucket_begins[bucket], end = bucket_begins[bucket + 1];
    for(int at = begin; at < end; ++at)
      ++next[std::size_t(key(std::size_t(by_bucket[std::size_t(at)])) - first_key) + 1];
    next[0] = begin;
    for(std::size_t k = 1; k < next.size(); ++k)
      lists.offsets[std::size_t(first_key) + k] = next[k] += next[k - 1];
    for(int at = begin; at < end; ++at)
    {
      const int i = by_bucket[std::size_t(at)];
      lists.items[std::size_t(next[std::size_t(key(std::size_t(i)) - first_key)]++)] = i;
    }
  });
  return lists;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_LISTS_H
