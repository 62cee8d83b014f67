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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_ARRANGE_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_ARRANGE_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/mesh/arrange.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE Error_code check_points(const std::vector<char>& is_bad, Reading& reading,
                                        const Indexed_triangles& mesh)
{
  for(int f = 0; f < mesh.number_of_triangles() && !is_bad.empty(); ++f)
    for(int row : mesh.rows_of(f))
      if(row < int(is_bad.size()) && is_bad[row])
      {
        reading.culprit.row = row;
        return error_invalid_point;
      }
  return ok;
}

CGAL_GDP_INLINE void settle_unused_points(const Lists& polygons, Indexed_triangles& mesh)
{
  std::vector<char> is_used(mesh.points.size(), 0);
  for(const auto& t : mesh.triangles)
    for(int row : t)
      if(row >= 0)
        is_used[row] = 1;
  for(int row : polygons.items)
    if(row >= 0)
      is_used[row] = 1;
  const auto used = std::find(is_used.begin(), is_used.end(), 1);
  if(used == is_used.end() || std::find(is_used.begin(), is_used.end(), 0) == is_used.end())
    return;
  const Vec3 place = mesh.points[used - is_used.begin()];
  for(std::size_t row = 0; row < is_used.size(); ++row)
    if(!is_used[row])
      mesh.points[row] = place;
  normalize_extent(mesh);
}

CGAL_GDP_INLINE double polygon_area(const std::vector<Vec3>& polygon)
{
  Indexed_triangles fan;
  fan.points = polygon;
  Lists corners;
  corners.offsets = {0, int(polygon.size())};
  for(int i = 0; i < int(polygon.size()); ++i)
    corners.items.push_back(i);
  fan_polygons(corners, fan);
  return fan.area(false);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_ARRANGE_IMPL_H
