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
