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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_MEMORY_ORDER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_MEMORY_ORDER_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Lists.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/morton_order.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

template <class T>
void permute(bool parallel, const std::vector<int>& order, std::vector<T>& items)
{
  std::vector<T> permuted(items.size());
  parallel_for(parallel, items.size(), [&](std::size_t i) { permuted[i] = items[order[i]]; });
  items.swap(permuted);
}

inline std::vector<int> inverse_permutation(const std::vector<int>& order)
{
  std::vector<int> inverse(order.size());
  for(std::size_t i = 0; i < order.size(); ++i)
    inverse[order[i]] = int(i);
  return inverse;
}

// Neighbors in space become neighbors in memory, whatever their order in the surface: all that loops over the arrays
// gains by it. Answers where the vertices were.
template <class Vertices>
std::vector<int> sort_vertices(bool parallel, Vertices& vertices, Indexed_triangles& mesh)
{
  std::vector<int> order = morton_order(mesh.points, parallel);
  permute(parallel, order, vertices);
  permute(parallel, order, mesh.points);
  return order;
}

// By their lowest vertex.
template <class Faces>
void sort_triangles(bool parallel, Faces& faces, Indexed_triangles& mesh)
{
  const std::vector<int> order =
    numbers_by_key(parallel, mesh.number_of_vertices(), mesh.triangles.size(), [&](std::size_t f) {
      return *std::min_element(mesh.triangles[f].begin(), mesh.triangles[f].end());
    }).items;
  if(!mesh.face_of_triangle.empty())
    permute(parallel, order, mesh.face_of_triangle);
  else
    permute(parallel, order, faces);
  if(!mesh.rows.empty())
    permute(parallel, order, mesh.rows);
  permute(parallel, order, mesh.triangles);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_MEMORY_ORDER_H
