// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_READ_MESH_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_READ_MESH_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/parameters.h>
#include <CGAL/Gradient_domain_processing/internal/energy/Linear_system.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/morton_order.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_for.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
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
inline void normalize_extent(Indexed_triangles& mesh)
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

// The triangles, and of each the set of its edges without a neighbor: 1, 2 and 4 for those from its first, second and third vertex.
template <class TriangleMesh, class Vertex_to_int>
Error_code read_faces(const TriangleMesh& tm, const Vertex_to_int& vertex_to_int, bool parallel,
                      const Mesh_elements<TriangleMesh>& elements, Indexed_triangles& mesh, std::vector<char>& border_edges)
{
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
  const std::array<int, 3> not_a_triangle = {{-1, -1, -1}};
  mesh.triangles.resize(elements.faces.size());
  border_edges.resize(elements.faces.size());
  // in steps: within one, no access to memory waits for another
  constexpr std::size_t block_size = 256;
  for_each_block(parallel, elements.faces.size(), block_size, [&](std::size_t begin, std::size_t end) {
    std::array<halfedge_descriptor, block_size> first, second, third;
    const std::size_t size = end - begin;
    for(std::size_t k = 0; k < size; ++k)
      first[k] = halfedge(elements.faces[begin + k], tm);
    for(std::size_t k = 0; k < size; ++k)
      second[k] = next(first[k], tm);
    for(std::size_t k = 0; k < size; ++k)
      third[k] = next(second[k], tm);
    for(std::size_t k = 0; k < size; ++k)
    {
      if(next(third[k], tm) != first[k] || third[k] == first[k] || second[k] == first[k])
      {
        mesh.triangles[begin + k] = not_a_triangle;
        continue;
      }
      const int source = vertex_to_int(target(third[k], tm)), middle = vertex_to_int(target(first[k], tm));
      mesh.triangles[begin + k] = {{source, middle, vertex_to_int(target(second[k], tm))}};
      const auto is_on_border = [&](halfedge_descriptor h) { return is_border(opposite(h, tm), tm); };
      border_edges[begin + k] = char(is_on_border(first[k]) + 2 * is_on_border(second[k]) + 4 * is_on_border(third[k]));
    }
  });
  const auto bad = std::find(mesh.triangles.begin(), mesh.triangles.end(), not_a_triangle);
  if(bad == mesh.triangles.end())
    return OK;
  mesh.triangles.erase(bad, mesh.triangles.end());
  return ERROR_NON_TRIANGULAR_MESH;
}

template <class TriangleMesh, class VertexPointMap>
Error_code read_points(VertexPointMap vpm, const Mesh_elements<TriangleMesh>& elements, Indexed_triangles& mesh)
{
  mesh.points.reserve(elements.vertices.size());
  for(auto v : elements.vertices)
  {
    mesh.points.push_back(to_vec3(get(vpm, v)));
    if(!is_valid_point(mesh.points.back()))
      return ERROR_INVALID_POINT;
  }
  normalize_extent(mesh);
  return OK;
}

template <class T>
void permute(bool parallel, const std::vector<int>& order, std::vector<T>& items)
{
  std::vector<T> permuted(items.size());
  parallel_for(parallel, items.size(), [&](std::size_t i) { permuted[i] = items[order[i]]; });
  items.swap(permuted);
}

// Neighbors in space become neighbors in memory, whatever the order in the mesh: all that loops over the arrays gains by it.
// Answers where the vertices were.
template <class TriangleMesh>
std::vector<int> sort_vertices(bool parallel, Mesh_elements<TriangleMesh>& elements, Indexed_triangles& mesh)
{
  std::vector<int> order = morton_order(mesh.points, parallel);
  permute(parallel, order, elements.vertices);
  permute(parallel, order, mesh.points);
  return order;
}

// By their lowest vertex.
template <class TriangleMesh>
void sort_faces(bool parallel, Mesh_elements<TriangleMesh>& elements, Indexed_triangles& mesh)
{
  const std::vector<int> order = items_by_key(mesh.number_of_vertices(), [&](const auto& visit) {
    for(int f = 0; f < mesh.number_of_triangles(); ++f)
      visit(*std::min_element(mesh.triangles[f].begin(), mesh.triangles[f].end()), f);
  }).items;
  permute(parallel, order, elements.faces);
  permute(parallel, order, mesh.triangles);
}

// The whole mesh; vertices without a face are among the vertices.
template <class TriangleMesh, class VertexPointMap, class NamedParameters>
Error_code read_mesh(const TriangleMesh& tm, VertexPointMap vpm, const NamedParameters& np, bool parallel,
                     Mesh_elements<TriangleMesh>& elements, Indexed_triangles& mesh)
{
  const auto index_map = CGAL::get_initialized_vertex_index_map(tm, np);
  elements.vertices.assign(vertices(tm).begin(), vertices(tm).end());
  elements.faces.assign(faces(tm).begin(), faces(tm).end());
  if(elements.faces.empty())
    return ERROR_EMPTY_MESH;

  if(const Error_code code = read_points(vpm, elements, mesh))
    return code;
  sort_vertices(parallel, elements, mesh);

  // indices have gaps where vertices were removed
  std::vector<int> local(elements.vertices.size());
  for(std::size_t v = 0; v < elements.vertices.size(); ++v)
  {
    const std::size_t index = get(index_map, elements.vertices[v]);
    if(index >= local.size())
      local.resize(index + index / 2 + 1);
    local[index] = int(v);
  }
  std::vector<char> border_edges;
  const auto vertex_to_int = [&](auto v) { return local[get(index_map, v)]; };
  if(const Error_code code = read_faces(tm, vertex_to_int, parallel, elements, mesh, border_edges))
    return code;

  mesh.is_on_border.assign(elements.vertices.size(), 0);
  for(std::size_t f = 0; f < border_edges.size(); ++f)
    for(int i = 0; i < 3; ++i)
      if(border_edges[f] & 1 << i)
        mesh.is_on_border[mesh.triangles[f][i]] = mesh.is_on_border[mesh.triangles[f][(i + 1) % 3]] = 1;
  sort_faces(parallel, elements, mesh);
  mesh.index_corners();
  return OK;
}

// A region: the given faces and their vertices. `is_fixed` marks the vertices at which a face outside the region is.
// Time and memory are those of the region.
template <class TriangleMesh, class FaceRange, class VertexPointMap>
Error_code read_region(const TriangleMesh& tm, const FaceRange& region, VertexPointMap vpm,
                       Mesh_elements<TriangleMesh>& elements, Indexed_triangles& mesh, std::vector<char>& is_fixed)
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
  std::vector<char> border_edges; // not all of them: the border may be among the faces outside of the region
  if(const Error_code code = read_faces(tm, vertex_to_int, false, elements, mesh, border_edges))
    return code;
  if(const Error_code code = read_points(vpm, elements, mesh))
    return code;
  const std::vector<int> order = sort_vertices(false, elements, mesh);
  std::vector<int> rank(order.size());
  for(std::size_t i = 0; i < order.size(); ++i)
    rank[order[i]] = int(i);
  for(auto& triangle : mesh.triangles)
    for(int& v : triangle)
      v = rank[v];
  sort_faces(false, elements, mesh);
  mesh.index_corners();

  mesh.is_on_border.assign(elements.vertices.size(), 0);
  is_fixed.assign(elements.vertices.size(), 0);
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
double total_area(const TriangleMesh& tm, VertexPointMap vpm, const Indexed_triangles& mesh, bool parallel)
{
  if(mesh.triangles.size() == num_faces(tm)) // the arrays are read several times as fast as the mesh
    return mesh.area(parallel);
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

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_READ_MESH_H
