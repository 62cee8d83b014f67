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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_SPLIT_POLYGONS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_SPLIT_POLYGONS_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Cuts a polygon into triangles, each time by the shortest diagonal that leaves a triangle turned like the polygon.
inline void cut_ears(std::vector<int> polygon, const std::vector<Vec3>& points,
                     std::vector<std::array<int, 3> >& triangles)
{
  Vec3 area_vector(0, 0, 0);
  for(std::size_t i = 1; i + 1 < polygon.size(); ++i)
    area_vector += (points[polygon[i]] - points[polygon[0]]).cross(points[polygon[i + 1]] - points[polygon[0]]);
  while(polygon.size() > 2)
  {
    const std::size_t n = polygon.size();
    std::size_t ear = 0;
    double least = 0;
    bool is_found = false;
    for(std::size_t i = 0; i < n; ++i)
    {
      const Vec3 &a = points[polygon[(i + n - 1) % n]], &b = points[polygon[i]], &c = points[polygon[(i + 1) % n]];
      const double length = (c - a).squaredNorm();
      const bool is_turned_alike = (b - a).cross(c - b).dot(area_vector) > 0;
      if(i == 0 || (is_turned_alike && (!is_found || length < least)))
      {
        ear = i;
        least = length;
        is_found = is_turned_alike;
      }
    }
    const std::array<int, 3> t = {{polygon[(ear + n - 1) % n], polygon[ear], polygon[(ear + 1) % n]}};
    if(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) // welded corners
      triangles.push_back(t);
    polygon.erase(polygon.begin() + std::ptrdiff_t(ear));
  }
}

// The mesh without the vertices in the middle of its polygons: they have less noise than others, being means of them.
inline Indexed_triangles split_polygons(const Indexed_triangles& mesh)
{
  Indexed_triangles result;
  result.points = mesh.points;
  result.exponent = mesh.exponent;
  result.is_on_border = mesh.is_on_border;
  for(const auto& t : mesh.triangles)
    if((std::max)({t[0], t[1], t[2]}) < mesh.first_virtual_vertex())
      result.triangles.push_back(t);
  const Lists& polygons = mesh.virtual_vertices.corners;
  for(int k = 0; k < polygons.size(); ++k)
  {
    std::vector<int> polygon(polygons.begin(k), polygons.end(k));
    for(int& v : polygon)
      v = mesh.vertex_of(v);
    cut_ears(std::move(polygon), mesh.points, result.triangles);
  }
  const auto lowest = [](const std::array<int, 3>& t) { return (std::min)({t[0], t[1], t[2]}); };
  std::stable_sort(result.triangles.begin(), result.triangles.end(),
                   [&](const auto& s, const auto& t) { return lowest(s) < lowest(t); });
  result.index_corners();
  return result;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_SPLIT_POLYGONS_H
