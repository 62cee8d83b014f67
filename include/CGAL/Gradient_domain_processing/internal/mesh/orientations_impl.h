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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_ORIENTATIONS_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_ORIENTATIONS_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/mesh/border_edges.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/orientations.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// visit(triangle, whether it has the edge in the other direction, as it should) for the neighbors of a triangle.
template <class Visit>
void for_each_neighbor_at_edge(const Indexed_triangles& mesh, int triangle, const Visit& visit)
{
  for(int i = 0; i < 3; ++i)
  {
    const int v = mesh.triangles[triangle][i], w = mesh.triangles[triangle][(i + 1) % 3];
    if(v == w || number_of_triangles_at_edge(mesh, v, w) != 2)
      continue;
    for(const int* c = mesh.corners.begin(v); c != mesh.corners.end(v); ++c)
      if(const auto ends = mesh.opposite_vertices(*c); *c / 3 != triangle && (ends[0] == w || ends[1] == w))
        visit(*c / 3, ends[1] == w);
  }
}

CGAL_GDP_INLINE std::vector<signed char> orientations(const Indexed_triangles& mesh)
{
  std::vector<signed char> sign(mesh.triangles.size(), 0);
  bool is_any_turned = false;
  std::vector<int> open;
  for(int first = 0; first < mesh.number_of_triangles(); ++first)
  {
    if(sign[first] != 0)
      continue;
    sign[first] = 1;
    open.push_back(first);
    while(!open.empty())
    {
      const int f = open.back();
      open.pop_back();
      for_each_neighbor_at_edge(mesh, f, [&](int g, bool is_alike) {
        if(sign[g] != 0)
          return;
        sign[g] = is_alike ? sign[f] : (signed char)(-sign[f]);
        is_any_turned = is_any_turned || sign[g] < 0;
        open.push_back(g);
      });
    }
  }
  if(!is_any_turned)
    sign.clear();
  return sign;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_ORIENTATIONS_IMPL_H
