// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_CONNECTED_COMPONENTS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_CONNECTED_COMPONENTS_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The connected component of every vertex.
struct Components
{
  std::vector<int> of_vertex;
  int count = 0;
};

inline Components connected_components(const Indexed_triangles& mesh)
{
  Components components;
  components.of_vertex.assign(mesh.number_of_vertices(), -1);
  std::vector<int> stack;
  for(int seed = 0; seed < mesh.number_of_vertices(); ++seed)
  {
    if(components.of_vertex[seed] >= 0)
      continue;
    stack.assign(1, seed);
    components.of_vertex[seed] = components.count;
    while(!stack.empty())
    {
      const int v = stack.back();
      stack.pop_back();
      for(const int* c = mesh.corners.begin(v); c != mesh.corners.end(v); ++c)
        for(int w : mesh.opposite_vertices(*c))
          if(components.of_vertex[w] < 0)
          {
            components.of_vertex[w] = components.count;
            stack.push_back(w);
          }
    }
    ++components.count;
  }
  return components;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_CONNECTED_COMPONENTS_H
