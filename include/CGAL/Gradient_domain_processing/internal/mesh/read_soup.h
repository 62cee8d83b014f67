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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_READ_SOUP_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_READ_SOUP_H

#include <CGAL/Gradient_domain_processing/internal/mesh/arrange.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/read_graph.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The polygons of a soup as they are in its ranges; indices out of range are -1.
template <class PointRange, class PolygonRange, class Faces>
Lists read_polygons(const Polygon_soup<PointRange, PolygonRange>& soup, const Faces& faces, bool parallel)
{
  const std::size_t number_of_points = std::size_t(std::distance(std::begin(soup.points), std::end(soup.points)));
  Lists polygons;
  polygons.offsets.assign(faces.size() + 1, 0);
  parallel_for(parallel, faces.size(), [&](std::size_t k) {
    const auto& polygon = soup.polygons[faces[k]];
    polygons.offsets[k + 1] = int(std::distance(std::begin(polygon), std::end(polygon)));
  });
  std::partial_sum(polygons.offsets.begin(), polygons.offsets.end(), polygons.offsets.begin());
  polygons.items.resize(std::size_t(polygons.offsets.back()));
  parallel_for(parallel, faces.size(), [&](std::size_t k) {
    int at = polygons.offsets[k];
    for(const auto& index : soup.polygons[faces[k]])
      polygons.items[std::size_t(at++)] = std::size_t(index) < number_of_points ? int(index) : -1;
  });
  return polygons;
}

// Moves polygons that are all triangles to the mesh.
void take_triangles(bool parallel, Lists& polygons, Indexed_triangles& mesh);

// Reads what `faces` of the elements say, by the points of `vertices` of the elements; `row_of_point` is the inverse of
// the latter.
template <class Soup>
Error_code read_soup_elements(const Soup& soup, std::vector<int>& row_of_point, Reading& reading,
                              Surface_elements<Soup>& elements, Indexed_triangles& mesh)
{
  Lists polygons = read_polygons(soup, elements.faces, reading.parallel);
  std::vector<char> is_bad = read_points(elements.vertices, [&](std::size_t v) { return soup.points[v]; }, mesh);
  const std::vector<int> order = sort_vertices(reading.parallel, elements.vertices, mesh);
  if(!is_bad.empty())
    permute(reading.parallel, order, is_bad);
  for(std::size_t row = 0; row < elements.vertices.size(); ++row)
    row_of_point[elements.vertices[row]] = int(row);
  parallel_for(reading.parallel, polygons.items.size(), [&](std::size_t i) {
    int& item = polygons.items[i];
    item = item < 0 ? item : row_of_point[item];
  });
  take_triangles(reading.parallel, polygons, mesh);
  if(const Error_code code = check_faces(polygons, reading, mesh))
    return code;
  arrange(reading, elements.faces, polygons, mesh);
  return check_points(is_bad, reading, mesh);
}

template <class PointRange, class PolygonRange, class PointMap, class NamedParameters>
Error_code read_surface(const Polygon_soup<PointRange, PolygonRange>& soup, PointMap, const NamedParameters&,
                        Reading& reading, Surface_elements<Polygon_soup<PointRange, PolygonRange> >& elements,
                        Indexed_triangles& mesh)
{
  const std::size_t number_of_points = std::size_t(std::distance(std::begin(soup.points), std::end(soup.points)));
  elements.vertices.resize(number_of_points);
  std::iota(elements.vertices.begin(), elements.vertices.end(), std::size_t(0));
  elements.faces.resize(std::size_t(std::distance(std::begin(soup.polygons), std::end(soup.polygons))));
  std::iota(elements.faces.begin(), elements.faces.end(), std::size_t(0));
  if(elements.faces.empty())
    return error_empty_mesh;
  std::vector<int> row_of_point(number_of_points, -1);
  return read_soup_elements(soup, row_of_point, reading, elements, mesh);
}

// Border vertices of the whole soup among those with a face outside of the region, by counting the faces at their
// edges.
template <class Soup>
void mark_border_outside(const Soup& soup, const std::vector<int>& row_of_point,
                         const std::vector<char>& has_face_outside, Indexed_triangles& mesh)
{
  std::map<std::pair<int, int>, int> faces_at_edge;
  const auto vertex_at = [&](std::size_t point) {
    return row_of_point[point] < 0 ? -1 - int(point) : mesh.vertex_of(row_of_point[point]);
  };
  for(const auto& polygon : soup.polygons)
  {
    const std::size_t n = polygon.size();
    for(std::size_t i = 0; i < n; ++i)
    {
      const int a = vertex_at(std::size_t(polygon[i])), b = vertex_at(std::size_t(polygon[(i + 1) % n]));
      if((a >= 0 && has_face_outside[a]) || (b >= 0 && has_face_outside[b]))
        ++faces_at_edge[std::minmax(a, b)];
    }
  }
  for(std::size_t v = 0; v < has_face_outside.size(); ++v)
    if(has_face_outside[v])
      mesh.is_on_border[v] = 0;
  for(const auto& edge : faces_at_edge)
    if(edge.second == 1)
      for(int v : {edge.first.first, edge.first.second})
        if(v >= 0 && has_face_outside[v])
          mesh.is_on_border[v] = 1;
}

template <class FaceRange, class PointRange, class PolygonRange, class PointMap, class NamedParameters>
Error_code read_region(const FaceRange& region, const Polygon_soup<PointRange, PolygonRange>& soup, PointMap,
                       const NamedParameters&, Reading& reading,
                       Surface_elements<Polygon_soup<PointRange, PolygonRange> >& elements, Indexed_triangles& mesh,
                       std::vector<char>& has_face_outside)
{
  const std::size_t number_of_points = std::size_t(std::distance(std::begin(soup.points), std::end(soup.points)));
  const std::size_t number_of_polygons = std::size_t(std::distance(std::begin(soup.polygons), std::end(soup.polygons)));
  std::vector<char> is_inside(number_of_polygons, 0), is_at_region(number_of_points, 0),
    is_at_outside(number_of_points, 0);
  for(const auto& f : region)
  {
    if(std::size_t(f) >= number_of_polygons)
      return error_invalid_region;
    is_inside[std::size_t(f)] = 1;
  }
  for(std::size_t f = 0; f < number_of_polygons; ++f)
  {
    if(is_inside[f])
      elements.faces.push_back(f);
    for(const auto& index : soup.polygons[f])
    {
      if(std::size_t(index) >= number_of_points)
      {
        elements.faces.assign(1, f);
        reading.culprit.face = 0;
        return error_invalid_index;
      }
      (is_inside[f] ? is_at_region : is_at_outside)[std::size_t(index)] = 1;
    }
  }
  for(std::size_t v = 0; v < number_of_points; ++v)
    if(is_at_region[v])
      elements.vertices.push_back(v);
  std::vector<int> row_of_point(number_of_points, -1);
  if(const Error_code code = read_soup_elements(soup, row_of_point, reading, elements, mesh))
    return code;
  has_face_outside.assign(mesh.points.size(), 0);
  for(std::size_t row = 0; row < elements.vertices.size(); ++row)
    if(is_at_outside[elements.vertices[row]])
      has_face_outside[mesh.vertex_of(int(row))] = 1;
  mark_border_outside(soup, row_of_point, has_face_outside, mesh);
  return ok;
}

template <class PointRange, class PolygonRange, class PointMap>
double total_area(const Polygon_soup<PointRange, PolygonRange>& soup, PointMap,
                  const Surface_elements<Polygon_soup<PointRange, PolygonRange> >& elements,
                  const Indexed_triangles& mesh, bool parallel)
{
  if(elements.faces.size() == std::size_t(std::distance(std::begin(soup.polygons), std::end(soup.polygons))))
    return mesh.area(parallel);
  const double factor = std::ldexp(1., -mesh.exponent);
  double sum = 0;
  std::vector<Vec3> polygon;
  for(const auto& corners : soup.polygons)
  {
    polygon.clear();
    for(const auto& index : corners)
      polygon.push_back(factor * to_vec3(soup.points[std::size_t(index)]));
    if(polygon.size() >= 3)
      sum += polygon_area(polygon);
  }
  return sum;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/mesh/read_soup_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_READ_SOUP_H
