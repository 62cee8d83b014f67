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

#include <cstddef>
#include <numeric>
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

// The items of every key, in the order in which for_each_pair(visit) calls visit(key, item). Counting sort.
template <class For_each_pair>
Lists items_by_key(int number_of_keys, const For_each_pair& for_each_pair)
{
  Lists lists;
  lists.offsets.assign(std::size_t(number_of_keys) + 1, 0);
  for_each_pair([&](int key, int) { ++lists.offsets[std::size_t(key) + 1]; });
  std::partial_sum(lists.offsets.begin(), lists.offsets.end(), lists.offsets.begin());
  lists.items.resize(std::size_t(lists.offsets.back()));
  std::vector<int> next(lists.offsets.begin(), lists.offsets.end() - 1);
  for_each_pair([&](int key, int item) { lists.items[std::size_t(next[std::size_t(key)]++)] = item; });
  return lists;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_LISTS_H
