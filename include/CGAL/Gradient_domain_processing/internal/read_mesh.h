// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_READ_MESH_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_READ_MESH_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/parameters.h>
#include <CGAL/Gradient_domain_processing/internal/Gradient_domain_system.h>
#include <CGAL/Gradient_domain_processing/internal/Mesh_arrays.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The elements of the mesh behind the arrays.
template <class TriangleMesh>
struct Mesh_elements
{
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;
  std::vector<typename boost::graph_traits<TriangleMesh>::face_descriptor> faces;
};

template <class Point>
Vec3 to_vec3(const Point& p)
{
  return Vec3(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]));
}

constexpr double largest_coordinate = 1e150;

inline bool is_valid_point(const Vec3& p)
{
  return (p.array().abs() <= largest_coordinate).all(); // false for NaN, which a maximum would lose
}

// Multiplies the points by the power of two that brings their extent near one.
inline void normalize_extent(Mesh_arrays& mesh)
{
  if(mesh.points.empty())
    return;
  Vec3 low = mesh.points[0], high = mesh.points[0];
  for(const Vec3& p : mesh.points)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double extent = (high - low).maxCoeff();
  if(!(extent > 0))
    return;
  std::frexp(extent, &mesh.exponent);
  mesh.exponent = (std::max)(mesh.exponent, -500); // lest the factor overflow
  const double factor = std::ldexp(1., -mesh.exponent);
  for(Vec3& p : mesh.points)
    p *= factor;
}

// mark_border(v, w) is called for the edges at which a face has no neighbor.
template <class TriangleMesh, class Vertex_to_int, class Mark_border>
Error_code read_faces(const TriangleMesh& tm, const Vertex_to_int& vertex_to_int, const Mark_border& mark_border,
                      Mesh_elements<TriangleMesh>& elements, Mesh_arrays& mesh)
{
  mesh.triangles.reserve(elements.faces.size());
  for(auto f : elements.faces)
  {
    const auto h = halfedge(f, tm), second = next(h, tm), third = next(second, tm);
    if(next(third, tm) != h || third == h || second == h)
      return ERROR_NON_TRIANGULAR_MESH;
    mesh.triangles.push_back({{vertex_to_int(target(third, tm)), vertex_to_int(target(h, tm)), vertex_to_int(target(second, tm))}});
    const auto& t = mesh.triangles.back();
    if(is_border(opposite(h, tm), tm))
      mark_border(t[0], t[1]);
    if(is_border(opposite(second, tm), tm))
      mark_border(t[1], t[2]);
    if(is_border(opposite(third, tm), tm))
      mark_border(t[2], t[0]);
  }
  return OK;
}

template <class TriangleMesh, class VertexPointMap>
Error_code read_points(VertexPointMap vpm, const Mesh_elements<TriangleMesh>& elements, Mesh_arrays& mesh)
{
  mesh.points.reserve(elements.vertices.size());
  for(auto v : elements.vertices)
  {
    mesh.points.push_back(to_vec3(get(vpm, v)));
    if(!is_valid_point(mesh.points.back()))
      return ERROR_INVALID_POINT;
  }
  normalize_extent(mesh);
  mesh.index_corners();
  return OK;
}

// The whole mesh; vertices without a face are among the vertices.
template <class TriangleMesh, class VertexPointMap, class NamedParameters>
Error_code read_mesh(const TriangleMesh& tm, VertexPointMap vpm, const NamedParameters& np,
                     Mesh_elements<TriangleMesh>& elements, Mesh_arrays& mesh)
{
  const auto index_map = CGAL::get_initialized_vertex_index_map(tm, np);
  elements.vertices.assign(vertices(tm).begin(), vertices(tm).end());
  elements.faces.assign(faces(tm).begin(), faces(tm).end());
  if(elements.faces.empty())
    return ERROR_EMPTY_MESH;

  // indices have gaps where vertices were removed
  std::vector<int> local(elements.vertices.size());
  for(std::size_t v = 0; v < elements.vertices.size(); ++v)
  {
    const std::size_t index = get(index_map, elements.vertices[v]);
    if(index >= local.size())
      local.resize(index + index / 2 + 1);
    local[index] = int(v);
  }
  const auto vertex_to_int = [&](auto v) { return local[get(index_map, v)]; };
  mesh.is_on_border.assign(elements.vertices.size(), 0);
  const auto mark_border = [&](int v, int w) { mesh.is_on_border[v] = mesh.is_on_border[w] = 1; };
  if(const Error_code code = read_faces(tm, vertex_to_int, mark_border, elements, mesh))
    return code;
  return read_points(vpm, elements, mesh);
}

// A region: the given faces and their vertices. `is_fixed` marks the vertices at which a face outside the region is.
// Time and memory are those of the region.
template <class TriangleMesh, class FaceRange, class VertexPointMap>
Error_code read_region(const TriangleMesh& tm, const FaceRange& region, VertexPointMap vpm,
                       Mesh_elements<TriangleMesh>& elements, Mesh_arrays& mesh, std::vector<char>& is_fixed)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;

  elements.faces.assign(region.begin(), region.end());
  std::sort(elements.faces.begin(), elements.faces.end());
  elements.faces.erase(std::unique(elements.faces.begin(), elements.faces.end()), elements.faces.end());

  std::unordered_map<vertex_descriptor, int> local;
  const auto vertex_to_int = [&](vertex_descriptor v) {
    const auto found = local.emplace(v, int(elements.vertices.size()));
    if(found.second)
      elements.vertices.push_back(v);
    return found.first->second;
  };
  // the border may be among the faces outside of the region
  if(const Error_code code = read_faces(tm, vertex_to_int, [](int, int) {}, elements, mesh))
    return code;
  if(const Error_code code = read_points(vpm, elements, mesh))
    return code;

  is_fixed.assign(elements.vertices.size(), 0);
  mesh.is_on_border.assign(elements.vertices.size(), 0);
  for(std::size_t v = 0; v < elements.vertices.size(); ++v)
  {
    int degree = 0;
    for(auto h : CGAL::halfedges_around_target(elements.vertices[v], tm))
      if(is_border(h, tm))
        mesh.is_on_border[v] = 1;
      else
        ++degree;
    is_fixed[v] = degree > mesh.corners.size(int(v));
  }
  return OK;
}

// The area of the whole mesh, in units of the arrays of it or of one of its regions.
template <class TriangleMesh, class VertexPointMap>
double total_area(const TriangleMesh& tm, VertexPointMap vpm, const Mesh_arrays& mesh)
{
  if(mesh.triangles.size() == num_faces(tm)) // the arrays are read several times as fast as the mesh
    return mesh.area();
  const double factor = std::ldexp(1., -mesh.exponent);
  double sum = 0;
  for(auto f : faces(tm))
  {
    const auto h = halfedge(f, tm);
    const Vec3 a = factor * to_vec3(get(vpm, source(h, tm))), b = factor * to_vec3(get(vpm, target(h, tm))),
               c = factor * to_vec3(get(vpm, target(next(h, tm), tm)));
    sum += Triangle_metric::embedding(a, b, c).with_area_bounded_below(degeneracy_ratio).area();
  }
  return sum;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_READ_MESH_H
