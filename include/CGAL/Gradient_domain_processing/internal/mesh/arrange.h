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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_ARRANGE_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_ARRANGE_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Surface_elements.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/border_edges.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/memory_order.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/points.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/polygon_fans.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/weld.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// What is asked for when a surface is read, and what is said of it.
struct Reading
{
  bool parallel = true;
  bool welds = false;
  double weld_tolerance = 0; // relative to the extent
  int number_of_welded_vertices = 0;
  Culprit culprit;
};

// Reads the points of the vertices; what is not a point is remembered, for no face may use it.
template <class Vertices, class Get_point>
std::vector<char> read_points(const Vertices& vertices, const Get_point& point, Indexed_triangles& mesh)
{
  std::vector<char> is_bad;
  mesh.points.reserve(vertices.size());
  for(const auto& v : vertices)
  {
    mesh.points.push_back(to_vec3(point(v)));
    if(!is_valid_point(mesh.points.back()))
    {
      is_bad.resize(vertices.size(), 0);
      is_bad[mesh.points.size() - 1] = 1;
      mesh.points.back().setZero();
    }
  }
  normalize_extent(mesh);
  return is_bad;
}

// Points that no face uses may be anywhere: they get the place of one that is used, and say nothing about the extent.
void settle_unused_points(const Lists& polygons, Indexed_triangles& mesh);

template <class Faces>
void index_triangles(bool parallel, Faces& faces, Indexed_triangles& mesh)
{
  sort_triangles(parallel, faces, mesh);
  mesh.index_corners(parallel);
  mark_border(mesh, parallel);
}

// Triangles or polygons are given by rows. Virtual vertices, order in memory, corners, welded seams.
template <class Faces>
void arrange(Reading& reading, Faces& faces, const Lists& polygons, Indexed_triangles& mesh)
{
  settle_unused_points(polygons, mesh);
  if(!polygons.offsets.empty())
    fan_polygons(polygons, mesh);
  index_triangles(reading.parallel, faces, mesh);
  if(!reading.welds)
    return;
  reading.number_of_welded_vertices = weld_border(reading.weld_tolerance, mesh);
  if(reading.number_of_welded_vertices > 0)
    index_triangles(reading.parallel, faces, mesh);
}

// Whether a face uses a vertex whose point is none.
Error_code check_points(const std::vector<char>& is_bad, Reading& reading, const Indexed_triangles& mesh);

double polygon_area(const std::vector<Vec3>& polygon);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/mesh/arrange_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_ARRANGE_H
