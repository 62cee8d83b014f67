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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_MESH_PART_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_MESH_PART_H

#include <CGAL/Gradient_domain_processing/internal/denoising/constants.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/connected_components.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The part of a mesh that lies at some of its vertices, all of their triangles included.
struct Mesh_part
{
  Indexed_triangles mesh;
  std::vector<int> vertices; // in the whole mesh

  Mesh_part(const Indexed_triangles& whole, std::vector<int> of_whole, std::vector<int>& place)
    : vertices(std::move(of_whole))
  {
    mesh.exponent = whole.exponent;
    std::vector<int> triangles;
    for(std::size_t i = 0; i < vertices.size(); ++i)
    {
      const int v = vertices[i];
      place[v] = int(i);
      mesh.points.push_back(whole.points[v]);
      mesh.is_on_border.push_back(whole.is_on_border[v]);
      for(const int* c = whole.corners.begin(v); c != whole.corners.end(v); ++c)
        if(*c % 3 == 0)
          triangles.push_back(*c / 3);
    }
    std::sort(triangles.begin(), triangles.end());
    for(int f : triangles)
      mesh.triangles.push_back(
        {{place[whole.triangles[f][0]], place[whole.triangles[f][1]], place[whole.triangles[f][2]]}});
    mesh.index_corners();
  }
};

// Vertices by component; those of small components, which tell little of their noise, are one part.
inline std::vector<std::vector<int> > parts_to_denoise(const Indexed_triangles& mesh)
{
  const Components components = connected_components(mesh);
  std::vector<int> sizes(std::size_t(components.count), 0), part(std::size_t(components.count), -1);
  for(int c : components.of_vertex)
    ++sizes[c];
  std::vector<std::vector<int> > parts;
  int small = -1;
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    const int c = components.of_vertex[v];
    const bool is_small = sizes[c] < denoising::least_component;
    int& p = is_small ? small : part[c];
    if(mesh.corners.size(v) == 0)
      continue;
    if(p < 0)
    {
      p = int(parts.size());
      parts.emplace_back();
    }
    parts[p].push_back(v);
  }
  return parts;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_MESH_PART_H
