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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_READ_GRAPH_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_READ_GRAPH_H

#include <CGAL/Gradient_domain_processing/parameters.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/arrange.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The triangles of a mesh by rows, or, if not all faces are triangles, its polygons.
template <class Graph, class Vertex_to_row>
Lists read_faces(const Graph& graph, const Vertex_to_row& vertex_to_row, bool parallel,
                 const Surface_elements<Graph>& elements, Indexed_triangles& mesh)
{
  typedef typename boost::graph_traits<Graph>::halfedge_descriptor halfedge_descriptor;
  const std::array<int, 3> not_a_triangle = {{-2, -2, -2}};
  mesh.triangles.resize(elements.faces.size());
  // in steps: within one, no access to memory waits for another
  constexpr std::size_t block_size = 256;
  for_each_block(parallel, elements.faces.size(), block_size, [&](std::size_t begin, std::size_t end) {
    std::array<halfedge_descriptor, block_size> first, second, third;
    const std::size_t size = end - begin;
    for(std::size_t k = 0; k < size; ++k)
      first[k] = halfedge(elements.faces[begin + k], graph);
    for(std::size_t k = 0; k < size; ++k)
      second[k] = next(first[k], graph);
    for(std::size_t k = 0; k < size; ++k)
      third[k] = next(second[k], graph);
    for(std::size_t k = 0; k < size; ++k)
      if(next(third[k], graph) != first[k] || third[k] == first[k] || second[k] == first[k])
        mesh.triangles[begin + k] = not_a_triangle;
      else
        mesh.triangles[begin + k] = {{vertex_to_row(target(third[k], graph)), vertex_to_row(target(first[k], graph)),
                                      vertex_to_row(target(second[k], graph))}};
  });
  Lists polygons;
  if(std::find(mesh.triangles.begin(), mesh.triangles.end(), not_a_triangle) == mesh.triangles.end())
    return polygons;
  polygons.offsets.push_back(0);
  for(auto f : elements.faces)
  {
    const auto first = halfedge(f, graph);
    auto h = first;
    do
    {
      polygons.items.push_back(vertex_to_row(source(h, graph)));
      h = next(h, graph);
    }
    while(h != first);
    polygons.offsets.push_back(int(polygons.items.size()));
  }
  return polygons;
}

// Whether all faces have three corners at least, and all corners a row.
Error_code check_faces(const Lists& polygons, Reading& reading, const Indexed_triangles& mesh);

// The rows of vertices by their indices. Indices have gaps where vertices were removed; -1 there.
template <class Vertices, class IndexMap>
Error_code rows_by_index(const Vertices& vertices, IndexMap index_map, Reading& reading, std::vector<int>& rows)
{
  const std::size_t most = 64 * vertices.size() + (1 << 20); // beyond it the map was never filled
  rows.assign(vertices.size(), -1);
  for(std::size_t v = 0; v < vertices.size(); ++v)
  {
    const std::size_t index = get(index_map, vertices[v]);
    if(index < most && index >= rows.size())
      rows.resize(index + index / 2 + 1, -1);
    if(index >= most || rows[index] >= 0)
    {
      reading.culprit.row = int(v);
      return error_invalid_index;
    }
    rows[index] = int(v);
  }
  return ok;
}

// The whole mesh; vertices without a face are among the vertices.
template <class Graph, class VertexPointMap, class NamedParameters>
Error_code read_surface(const Graph& graph, VertexPointMap vpm, const NamedParameters& np, Reading& reading,
                        Surface_elements<Graph>& elements, Indexed_triangles& mesh)
{
  const auto index_map = CGAL::get_initialized_vertex_index_map(graph, np);
  elements.vertices.assign(vertices(graph).begin(), vertices(graph).end());
  elements.faces.assign(faces(graph).begin(), faces(graph).end());
  if(elements.faces.empty())
    return error_empty_mesh;

  std::vector<char> is_bad = read_points(elements.vertices, [&](auto v) { return get(vpm, v); }, mesh);
  const std::vector<int> order = sort_vertices(reading.parallel, elements.vertices, mesh);
  if(!is_bad.empty())
    permute(reading.parallel, order, is_bad);

  std::vector<int> rows;
  if(const Error_code code = rows_by_index(elements.vertices, index_map, reading, rows))
    return code;
  const auto vertex_to_row = [&](auto v) {
    const std::size_t index = get(index_map, v);
    return index < rows.size() ? rows[index] : -1;
  };
  const Lists polygons = read_faces(graph, vertex_to_row, reading.parallel, elements, mesh);
  if(const Error_code code = check_faces(polygons, reading, mesh))
    return code;
  arrange(reading, elements.faces, polygons, mesh);
  return check_points(is_bad, reading, mesh);
}

// A Surface_mesh knows its indices; of another graph's descriptors only the null one is known to be none.
template <class Graph, class = void>
struct Face_check
{
  static bool is_face(typename boost::graph_traits<Graph>::face_descriptor f, const Graph&)
  {
    return f != boost::graph_traits<Graph>::null_face();
  }
};
template <class Graph>
struct Face_check<Graph, decltype(void(std::declval<const Graph&>().has_valid_index(
                           std::declval<typename boost::graph_traits<Graph>::face_descriptor>())))>
{
  static bool is_face(typename boost::graph_traits<Graph>::face_descriptor f, const Graph& graph)
  {
    return graph.has_valid_index(f) && !graph.is_removed(f);
  }
};

// The vertices at which a face outside of the region is, and the border of the mesh there.
template <class Graph>
void mark_vertices_with_faces_outside(const Graph& graph, const Surface_elements<Graph>& elements,
                                      Indexed_triangles& mesh, std::vector<char>& has_face_outside)
{
  std::vector<int> degree(mesh.number_of_vertices(), 0), faces_inside(mesh.number_of_vertices(), 0);
  std::vector<char> is_on_border(mesh.number_of_vertices(), 0);
  has_face_outside.assign(mesh.number_of_vertices(), 0);
  for(std::size_t row = 0; row < elements.vertices.size(); ++row)
  {
    const int v = mesh.vertex_of(int(row));
    for(auto h : CGAL::halfedges_around_target(elements.vertices[row], graph))
      if(is_border(h, graph))
        is_on_border[v] = 1;
      else
        ++degree[v];
  }
  for(int v = 0; v < mesh.first_virtual_vertex(); ++v)
  {
    int last_face = -1; // the triangles of a fan are one face, and come one after the other
    for(const int* c = mesh.corners.begin(v); c != mesh.corners.end(v); ++c)
      if(mesh.face_of(*c / 3) != last_face)
      {
        last_face = mesh.face_of(*c / 3);
        ++faces_inside[v];
      }
    has_face_outside[v] = degree[v] > faces_inside[v];
    if(has_face_outside[v])
      mesh.is_on_border[v] = is_on_border[v];
  }
}

// A region: the given faces and their vertices, in time and memory of the region.
template <class FaceRange, class Graph, class VertexPointMap, class NamedParameters>
Error_code read_region(const FaceRange& region, const Graph& graph, VertexPointMap vpm, const NamedParameters&,
                       Reading& reading, Surface_elements<Graph>& elements, Indexed_triangles& mesh,
                       std::vector<char>& has_face_outside)
{
  typedef typename boost::graph_traits<Graph>::vertex_descriptor vertex_descriptor;
  reading.parallel = false;
  elements.faces.assign(region.begin(), region.end());
  for(auto f : elements.faces)
    if(!Face_check<Graph>::is_face(f, graph))
      return error_invalid_region;
  std::sort(elements.faces.begin(), elements.faces.end());
  elements.faces.erase(std::unique(elements.faces.begin(), elements.faces.end()), elements.faces.end());

  std::unordered_map<vertex_descriptor, int> row_of;
  const auto vertex_to_row = [&](vertex_descriptor v) {
    const auto found = row_of.emplace(v, int(elements.vertices.size()));
    if(found.second)
      elements.vertices.push_back(v);
    return found.first->second;
  };
  Lists polygons = read_faces(graph, vertex_to_row, false, elements, mesh);
  if(const Error_code code = check_faces(polygons, reading, mesh))
    return code;
  std::vector<char> is_bad = read_points(elements.vertices, [&](auto v) { return get(vpm, v); }, mesh);
  const std::vector<int> order = sort_vertices(false, elements.vertices, mesh), rank = inverse_permutation(order);
  if(!is_bad.empty())
    permute(false, order, is_bad);
  for(auto& triangle : mesh.triangles)
    for(int& row : triangle)
      row = row < 0 ? row : rank[row];
  for(int& row : polygons.items)
    row = rank[row];
  arrange(reading, elements.faces, polygons, mesh);
  mark_vertices_with_faces_outside(graph, elements, mesh, has_face_outside);
  return check_points(is_bad, reading, mesh);
}

// The area of the whole mesh, in units of the arrays of it or of one of its regions.
template <class Graph, class VertexPointMap>
double total_area(const Graph& graph, VertexPointMap vpm, const Surface_elements<Graph>& elements,
                  const Indexed_triangles& mesh, bool parallel)
{
  if(elements.faces.size() == num_faces(graph)) // the arrays are read several times as fast as the mesh
    return mesh.area(parallel);
  const double factor = std::ldexp(1., -mesh.exponent);
  double sum = 0;
  std::vector<Vec3> polygon;
  for(auto f : faces(graph))
  {
    polygon.clear();
    for(auto v : CGAL::vertices_around_face(halfedge(f, graph), graph))
      polygon.push_back(factor * to_vec3(get(vpm, v)));
    sum += polygon.size() == 3 // vertices_around_face() begins with the target of halfedge(f)
             ? Triangle_metric::embedding(polygon[2], polygon[0], polygon[1])
                 .with_area_bounded_below(degeneracy_ratio)
                 .area()
             : polygon_area(polygon);
  }
  return sum;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/mesh/read_graph_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_READ_GRAPH_H
