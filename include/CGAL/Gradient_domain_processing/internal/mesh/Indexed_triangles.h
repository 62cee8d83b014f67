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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_INDEXED_TRIANGLES_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_INDEXED_TRIANGLES_H

#include <CGAL/Gradient_domain_processing/Triangle_metric.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Lists.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_for.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

typedef Eigen::Vector3d Vec3;

// No triangle is taken to have less area than this times its largest squared edge length (twice the area, to be
// precise): the square root of the machine precision, far below what a mesh of any use contains.
constexpr double degeneracy_ratio = 1.5e-8;

// One row a vertex, one column a channel of the signal; a vertex's channels lie together.
typedef Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> Signal;

// Vertices in the middle of polygons. Each is a weighted mean of the polygon's corners, in space as in every signal.
struct Virtual_vertices
{
  Lists corners;               // rows of signals
  std::vector<double> weights; // of each corner; they sum up to one

  int size() const { return corners.offsets.empty() ? 0 : corners.size(); }

  // of vectors at the corners, of(row)
  template <class Of>
  Vec3 mean(int k, const Of& of) const
  {
    Vec3 sum = Vec3::Zero();
    for(int at = corners.offsets[k]; at < corners.offsets[k + 1]; ++at)
      sum += weights[std::size_t(at)] * of(corners.items[at]);
    return sum;
  }
};

// The surface, or the region of it that is worked on: points and index triples, a soup with any number of triangles at
// an edge. Points are multiplied by a power of two that brings the extent near one: no product over- or underflows, and
// not a bit is lost. Vertices are in an order of our own, triangles in that of their lowest vertices.
//
// Signals have a row for every vertex of the surface. Where several of these are welded, they are one vertex here, with
// several rows. Polygons are fans around virtual vertices, whose vertices and rows are the last.
struct Indexed_triangles
{
  std::vector<Vec3> points;
  std::vector<std::array<int, 3> > triangles;
  Lists corners;                  // of every vertex: 3 * triangle + position in it, by increasing triangle
  std::vector<char> is_on_border; // by vertex: at an edge of one triangle
  int exponent = 0;               // a length in the arrays is the true one times 2^-exponent

  std::vector<int> vertex_of_row;             // none: row v is that of vertex v
  std::vector<std::array<int, 3> > rows;      // of the triangles' corners; none: their vertices
  std::vector<int> face_of_triangle;          // of the surface; none: triangle f is face f
  Virtual_vertices virtual_vertices;

  int number_of_vertices() const { return static_cast<int>(points.size()); }
  int number_of_triangles() const { return static_cast<int>(triangles.size()); }
  int number_of_rows() const
  {
    return vertex_of_row.empty() ? number_of_vertices() : static_cast<int>(vertex_of_row.size());
  }
  int number_of_surface_vertices() const { return number_of_rows() - virtual_vertices.size(); }
  int first_virtual_vertex() const { return number_of_vertices() - virtual_vertices.size(); }
  double unit() const { return std::ldexp(1., exponent); }

  int vertex_of(int row) const { return vertex_of_row.empty() ? row : vertex_of_row[row]; }
  const std::array<int, 3>& rows_of(int f) const { return rows.empty() ? triangles[f] : rows[f]; }
  int face_of(int f) const { return face_of_triangle.empty() ? f : face_of_triangle[f]; }

  Triangle_metric embedding_metric(int f) const
  {
    const auto& t = triangles[f];
    return Triangle_metric::embedding(points[t[0]], points[t[1]], points[t[2]]);
  }

  double area(bool parallel) const;

  void index_corners(bool parallel = false);

  // The two other vertices of the triangle at a corner, in its orientation.
  std::array<int, 2> opposite_vertices(int corner) const
  {
    const auto& t = triangles[corner / 3];
    const int i = corner % 3;
    return {{t[(i + 1) % 3], t[(i + 2) % 3]}};
  }

  // Twice the area times the normal; with the vertices elsewhere.
  Vec3 area_vector(int f) const { return area_vector(f, points); }
  Vec3 area_vector(int f, const std::vector<Vec3>& at) const
  {
    const auto& t = triangles[f];
    return (at[t[1]] - at[t[0]]).cross(at[t[2]] - at[t[0]]);
  }

  // The neighbors of every vertex.
  Lists one_rings(bool parallel) const;

  // Sums of the area-weighted normals of the incident triangles, normalized; zero where they cancel.
  std::vector<Vec3> vertex_normals(bool parallel) const { return vertex_normals(points, parallel); }
  std::vector<Vec3> vertex_normals(const std::vector<Vec3>& at, bool parallel) const;
};

std::vector<Vec3> as_vectors(const Signal& signal);

Signal as_signal(const std::vector<Vec3>& vectors);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_INDEXED_TRIANGLES_H
