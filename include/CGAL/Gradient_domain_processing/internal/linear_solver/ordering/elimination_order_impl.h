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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_ELIMINATION_ORDER_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_ELIMINATION_ORDER_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/elimination_order.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/nested_dissection.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE std::vector<int> postorder(const std::vector<int>& parent)
{
  const int n = int(parent.size());
  std::vector<int> first_child(n + 1, -1), next_sibling(n, -1), order, path; // the roots are children of n
  for(int j = n - 1; j >= 0; --j)
    next_sibling[j] = std::exchange(first_child[parent[j] < 0 ? n : parent[j]], j);
  order.reserve(n);
  for(int root = first_child[n]; root != -1; root = next_sibling[root])
  {
    path.push_back(root);
    while(!path.empty())
    {
      const int child = first_child[path.back()];
      if(child != -1)
      {
        first_child[path.back()] = next_sibling[child];
        path.push_back(child);
      }
      else
      {
        order.push_back(path.back());
        path.pop_back();
      }
    }
  }
  return order;
}

CGAL_GDP_INLINE Degrees_of_freedom elimination_order(const std::vector<Vec3>& points, const Lists& graph,
                                                     const std::vector<char>& is_solved_for, bool parallel,
                                                     const std::function<bool()>& go_on)
{
  std::vector<int> order = nested_dissection(points, graph.offsets, graph.items, parallel, go_on);
  order.erase(std::remove_if(order.begin(), order.end(), [&](int v) { return !is_solved_for[v]; }), order.end());
  const std::vector<int> place = numbered(order, points.size()).of_vertex;
  bool is_cancelled = false;
  std::vector<int> result = postorder(elimination_tree(int(order.size()), [&](int j, const auto& visit) {
    if(j % 20000 == 0 && go_on && !is_cancelled)
      is_cancelled = !go_on();
    for(const int* w = graph.begin(order[j]); w != graph.end(order[j]) && !is_cancelled; ++w)
      if(place[*w] >= 0 && place[*w] < j)
        visit(place[*w]);
  }));
  if(is_cancelled)
    result.clear();
  for(int& j : result)
    j = order[j];
  return numbered(std::move(result), points.size());
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_ELIMINATION_ORDER_IMPL_H
