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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_BORDER_EDGES_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_BORDER_EDGES_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/mesh/border_edges.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE std::vector<Border_edge> border_edges(const Indexed_triangles& mesh)
{
  std::vector<Border_edge> edges;
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    if(mesh.is_on_border[v])
      for_each_border_corner(mesh, v, [&](int c) { edges.push_back({c / 3, c % 3, (c % 3 + 1) % 3}); });
  return edges;
}

// The first triangle with an edge.
inline int first_triangle_at_edge(const Indexed_triangles& mesh, int vertex, int other)
{
  const int* c = mesh.corners.begin(vertex);
  for(; c != mesh.corners.end(vertex); ++c)
    if(const auto ends = mesh.opposite_vertices(*c); ends[0] == other || ends[1] == other)
      break;
  return *c / 3;
}

CGAL_GDP_INLINE std::vector<Border_edge> line_edges(const Indexed_triangles& mesh)
{
  std::vector<Border_edge> edges;
  for(int f = 0; f < mesh.number_of_triangles(); ++f)
    for(int i = 0; i < 3; ++i)
    {
      const int v = mesh.triangles[f][i], w = mesh.triangles[f][(i + 1) % 3];
      if(v != w && number_of_triangles_at_edge(mesh, v, w) > 2 && first_triangle_at_edge(mesh, v, w) == f)
        edges.push_back({f, i, (i + 1) % 3});
    }
  return edges;
}

CGAL_GDP_INLINE std::vector<char> vertices_at(const std::vector<Border_edge>& edges, const Indexed_triangles& mesh)
{
  std::vector<char> is_at(mesh.points.size(), 0);
  for(const Border_edge& e : edges)
    is_at[mesh.triangles[e.triangle][e.from]] = is_at[mesh.triangles[e.triangle][e.to]] = 1;
  return is_at;
}

CGAL_GDP_INLINE void mark_border(Indexed_triangles& mesh, bool parallel)
{
  mesh.is_on_border.assign(mesh.points.size(), 0);
  for_each_block(parallel, mesh.points.size(), 2048, [&](std::size_t begin, std::size_t end) {
    std::vector<int> ends; // of the edges at a vertex, once for every corner
    for(std::size_t v = begin; v < end; ++v)
    {
      ends.clear();
      for(const int* c = mesh.corners.begin(int(v)); c != mesh.corners.end(int(v)); ++c)
        for(int w : mesh.opposite_vertices(*c))
          ends.push_back(w);
      mesh.is_on_border[v] =
        std::any_of(ends.begin(), ends.end(), [&](int w) { return std::count(ends.begin(), ends.end(), w) == 1; });
    }
  });
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_BORDER_EDGES_IMPL_H
