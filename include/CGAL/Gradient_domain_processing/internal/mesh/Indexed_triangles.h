// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_INDEXED_TRIANGLES_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_INDEXED_TRIANGLES_H

#include <CGAL/Gradient_domain_processing/Triangle_metric.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_for.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

typedef Eigen::Vector3d Vec3;

// No triangle is taken to have less area than this times its largest squared edge length (twice the area, to be precise): the
// square root of the machine precision, far below what a mesh of any use contains.
constexpr double degeneracy_ratio = 1.5e-8;

// One row a vertex, one column a channel of the signal; a vertex's channels lie together.
typedef Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> Signal;

// A list of lists of numbers, end to end.
struct Lists
{
  std::vector<int> offsets; // size + 1
  std::vector<int> items;

  int size() const { return static_cast<int>(offsets.size()) - 1; }
  const int* begin(int i) const { return items.data() + offsets[i]; }
  const int* end(int i) const { return items.data() + offsets[i + 1]; }
  int size(int i) const { return offsets[i + 1] - offsets[i]; }
};

// The items of every key, in the order in which for_each_pair(visit) calls visit(key, item). Counting sort.
template <class For_each_pair>
Lists items_by_key(int number_of_keys, const For_each_pair& for_each_pair)
{
  Lists lists;
  lists.offsets.assign(number_of_keys + 1, 0);
  for_each_pair([&](int key, int) { ++lists.offsets[key + 1]; });
  std::partial_sum(lists.offsets.begin(), lists.offsets.end(), lists.offsets.begin());
  lists.items.resize(lists.offsets.back());
  std::vector<int> next(lists.offsets.begin(), lists.offsets.end() - 1);
  for_each_pair([&](int key, int item) { lists.items[next[key]++] = item; });
  return lists;
}

// The mesh, or the region of it that is worked on, as arrays. Points are multiplied by a power of two that brings the extent
// near one: no product over- or underflows, and not a bit is lost. Vertices are in an order of our own, triangles in that of their
// lowest vertices.
struct Indexed_triangles
{
  std::vector<Vec3> points;
  std::vector<std::array<int, 3> > triangles; // source and target of halfedge(f), target of the next
  Lists corners;                              // of every vertex: 3 * triangle + position in it, by increasing triangle
  std::vector<char> is_on_border;             // of the mesh
  int exponent = 0;                           // a length in the arrays is the true one times 2^-exponent

  int number_of_vertices() const { return static_cast<int>(points.size()); }
  int number_of_triangles() const { return static_cast<int>(triangles.size()); }
  double unit() const { return std::ldexp(1., exponent); }

  Triangle_metric embedding_metric(int f) const
  {
    const auto& t = triangles[f];
    return Triangle_metric::embedding(points[t[0]], points[t[1]], points[t[2]]);
  }

  double area(bool parallel) const
  {
    return sum_over_blocks(parallel, triangles.size(), 4096, 0., [&](std::size_t begin, std::size_t end) {
      double sum = 0;
      for(std::size_t f = begin; f < end; ++f)
        sum += embedding_metric(int(f)).with_area_bounded_below(degeneracy_ratio).area();
      return sum;
    });
  }

  void index_corners()
  {
    corners = items_by_key(number_of_vertices(), [&](const auto& visit) {
      for(int f = 0; f < number_of_triangles(); ++f)
        for(int i = 0; i < 3; ++i)
          visit(triangles[f][i], 3 * f + i);
    });
  }

  // The two other vertices of the triangle at a corner, in its orientation.
  std::array<int, 2> opposite_vertices(int corner) const
  {
    const auto& t = triangles[corner / 3];
    const int i = corner % 3;
    return {{t[(i + 1) % 3], t[(i + 2) % 3]}};
  }

  // The neighbors of every vertex.
  Lists one_rings(bool parallel) const
  {
    const int n = number_of_vertices();
    Lists rings;
    rings.offsets.assign(n + 1, 0);
    std::vector<int> found(2 * corners.items.size());
    parallel_for(parallel, n, [&](std::size_t v) {
      int* const first = found.data() + 2 * std::size_t(corners.offsets[v]);
      int* last = first;
      for(const int* c = corners.begin(int(v)); c != corners.end(int(v)); ++c)
        for(int w : opposite_vertices(*c))
        {
          const int* at = first;
          while(at != last && *at != w)
            ++at;
          if(at == last && w != int(v))
            *last++ = w;
        }
      rings.offsets[v + 1] = int(last - first);
    });
    for(int v = 0; v < n; ++v)
      rings.offsets[v + 1] += rings.offsets[v];
    rings.items.resize(rings.offsets[n]);
    parallel_for(parallel, n, [&](std::size_t v) {
      const int* const first = found.data() + 2 * std::size_t(corners.offsets[v]);
      std::copy(first, first + rings.size(int(v)), rings.items.begin() + rings.offsets[v]);
    });
    return rings;
  }

  // Sums of the area-weighted normals of the incident triangles, normalized; zero where they cancel.
  std::vector<Vec3> vertex_normals(bool parallel) const
  {
    std::vector<Vec3> normals(points.size());
    parallel_for(parallel, points.size(), [&](std::size_t v) {
      Vec3 sum(0, 0, 0);
      for(const int* c = corners.begin(int(v)); c != corners.end(int(v)); ++c)
      {
        const auto& t = triangles[*c / 3];
        sum += (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
      }
      const double length = sum.norm();
      normals[v] = length > 0 ? Vec3(sum / length) : Vec3(0, 0, 0);
    });
    return normals;
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_INDEXED_TRIANGLES_H
