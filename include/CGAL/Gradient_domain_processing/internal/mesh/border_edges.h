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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_BORDER_EDGES_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_BORDER_EDGES_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// An edge with one triangle, from one corner of it to the next.
struct Border_edge
{
  int triangle, from, to; // corners
};

// How many corners at the vertex belong to triangles with the edge to `other`.
inline int number_of_triangles_at_edge(const Indexed_triangles& mesh, int vertex, int other)
{
  int count = 0;
  for(const int* c = mesh.corners.begin(vertex); c != mesh.corners.end(vertex); ++c)
  {
    const auto ends = mesh.opposite_vertices(*c);
    count += (ends[0] == other) + (ends[1] == other);
  }
  return count;
}

// visit(corner) for every corner from which a border edge leaves in the orientation of its triangle.
template <class Visit>
void for_each_border_corner(const Indexed_triangles& mesh, int vertex, const Visit& visit)
{
  for(const int* c = mesh.corners.begin(vertex); c != mesh.corners.end(vertex); ++c)
    if(number_of_triangles_at_edge(mesh, vertex, mesh.opposite_vertices(*c)[0]) == 1)
      visit(*c);
}

std::vector<Border_edge> border_edges(const Indexed_triangles& mesh);

// Edges with three triangles or more, where sheets meet in a line: each once, as its first triangle has it.
std::vector<Border_edge> line_edges(const Indexed_triangles& mesh);

std::vector<char> vertices_at(const std::vector<Border_edge>& edges, const Indexed_triangles& mesh);

// A vertex is on the border if an edge of one triangle leaves it or arrives at it.
void mark_border(Indexed_triangles& mesh, bool parallel);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/mesh/border_edges_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_BORDER_EDGES_H
