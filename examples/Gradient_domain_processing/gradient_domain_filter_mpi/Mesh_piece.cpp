// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Mesh_piece.h"

#include <CGAL/Gradient_domain_processing/internal/mesh/border_edges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace {

using CGAL::Gradient_domain_processing::internal::Indexed_triangles;
using CGAL::Gradient_domain_processing::internal::Vec3;

typedef std::array<Global, 3> Corners;

// By vertices and, as far as they are known, rows.
struct Triangle
{
  Global face;
  Corners vertices, rows;
};

template <class T, class Corners_of>
std::vector<Global> foreign_corners(const std::vector<T>& triangles, Global first, Global last,
                                    const Corners_of& corners_of)
{
  std::vector<Global> ghosts;
  for(const T& t : triangles)
    for(Global v : corners_of(t))
      if(v < first || v >= last)
        ghosts.push_back(v);
  std::sort(ghosts.begin(), ghosts.end());
  ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
  return ghosts;
}

template <class T, class Corners_of>
Halo make_halo(const Ranks& ranks, const std::vector<Global>& first_of_ranks, const std::vector<T>& triangles,
               const Corners_of& corners_of)
{
  const std::size_t rank = std::size_t(ranks.rank());
  return Halo(ranks, first_of_ranks,
              foreign_corners(triangles, first_of_ranks[rank], first_of_ranks[rank + 1], corners_of));
}

// Of every owned row the lowest one that is the same vertex: another one at a border, in the same place.
std::vector<int> welded_rows(const Partition& partition, const Halo& rows, bool welds)
{
  std::vector<int> first(std::size_t(rows.owned()));
  std::iota(first.begin(), first.end(), 0);
  if(!welds)
    return first;
  Indexed_triangles by_row;
  by_row.points.resize(std::size_t(rows.size()));
  for(const Row_triangle& t : partition.triangles)
    by_row.triangles.push_back({{rows.local(t.rows[0]), rows.local(t.rows[1]), rows.local(t.rows[2])}});
  by_row.index_corners();
  CGAL::Gradient_domain_processing::internal::mark_border(by_row, false);
  std::vector<int> candidates;
  for(int row = 0; row < rows.owned(); ++row)
    if(by_row.is_on_border[std::size_t(row)])
      candidates.push_back(row);
  const auto coordinates = [&](int row) {
    const Vec3& p = partition.points[std::size_t(row)];
    return std::array<double, 3>{{p[0], p[1], p[2]}};
  };
  std::sort(candidates.begin(), candidates.end(), [&](int a, int b) {
    return std::make_pair(coordinates(a), a) < std::make_pair(coordinates(b), b);
  });
  for(std::size_t i = 1; i < candidates.size(); ++i)
    if(coordinates(candidates[i]) == coordinates(candidates[i - 1]))
      first[std::size_t(candidates[i])] = first[std::size_t(candidates[i - 1])];
  return first;
}

// Numbers the vertices that have a triangle; returns the vertex of every local row.
std::vector<Global> number_vertices(const Ranks& ranks, const Partition& partition, bool welds, Mesh_piece& piece,
                                    std::vector<Global>& first_vertex)
{
  const Halo& rows = piece.rows;
  std::vector<int> first;
  std::vector<char> is_used(std::size_t(rows.owned()), 0);
  ranks.together([&] {
    first = welded_rows(partition, rows, welds);
    for(const Row_triangle& t : partition.triangles)
      for(Global row : t.rows)
        if(rows.is_owned(row))
          is_used[std::size_t(first[std::size_t(rows.local(row))])] = 1;
  });
  Global count = 0, welded = 0;
  std::vector<Global> vertices(std::size_t(rows.size()), -1);
  piece.vertex_of_row.assign(std::size_t(rows.owned()), -1);
  for(std::size_t row = 0; row < is_used.size(); ++row)
  {
    const std::size_t same = std::size_t(first[row]); // not above
    if(same < row)
      ++welded;
    if(is_used[same])
      piece.vertex_of_row[row] = same < row ? piece.vertex_of_row[same] : int(count++);
  }
  piece.number_of_welded_rows = int(ranks.sum(welded));
  first_vertex = ranks.first_of_ranks(count);
  for(std::size_t row = 0; row < is_used.size(); ++row)
    if(piece.vertex_of_row[row] >= 0)
      vertices[row] = first_vertex[std::size_t(ranks.rank())] + piece.vertex_of_row[row];
  rows.update(vertices);
  return vertices;
}

// The triangles around ghosts that are not complete yet, from the owners of these.
void add_layer(const Ranks& ranks, const std::vector<Global>& first_vertex, const std::vector<Triangle>& own,
               std::vector<Triangle>& triangles)
{
  const auto corners_of = [](const Triangle& t) -> const Corners& { return t.vertices; };
  const std::size_t rank = std::size_t(ranks.rank());
  const Global begin = first_vertex[rank], end = first_vertex[rank + 1];
  const std::vector<Global> ghosts = foreign_corners(triangles, begin, end, corners_of);
  std::vector<int> counts(std::size_t(ranks.size()), 0), asked;
  for(Global g : ghosts)
    ++counts[std::size_t(owner(first_vertex, g))];
  const std::vector<Global> wanted = ranks.exchange(ghosts, counts, &asked);

  std::vector<std::vector<int> > at_vertex(std::size_t(end - begin));
  for(std::size_t t = 0; t < own.size(); ++t)
    for(Global v : own[t].vertices)
      if(v >= begin && v < end)
        at_vertex[std::size_t(v - begin)].push_back(int(t));
  std::vector<Triangle> outgoing;
  std::vector<int> outgoing_counts;
  std::size_t at = 0;
  for(int count : asked)
  {
    std::vector<int> numbers;
    for(int k = 0; k < count; ++k, ++at)
      numbers.insert(numbers.end(), at_vertex[std::size_t(wanted[at] - begin)].begin(),
                     at_vertex[std::size_t(wanted[at] - begin)].end());
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    for(int t : numbers)
      outgoing.push_back(own[std::size_t(t)]);
    outgoing_counts.push_back(int(numbers.size()));
  }
  const std::vector<Triangle> incoming = ranks.exchange(outgoing, outgoing_counts);
  triangles.insert(triangles.end(), incoming.begin(), incoming.end());
  std::sort(triangles.begin(), triangles.end(), [](const Triangle& a, const Triangle& b) { return a.face < b.face; });
  const auto is_same = [](const Triangle& a, const Triangle& b) { return a.face == b.face; };
  triangles.erase(std::unique(triangles.begin(), triangles.end(), is_same), triangles.end());
}

// A power of two, so that nothing is rounded.
int exponent_of(double extent)
{
  int power = 0;
  std::frexp(extent, &power);
  return extent > 0 ? (std::max)(power, -500) : 0;
}

void set_points(const Ranks& ranks, const Partition& partition, Mesh_piece& piece)
{
  Indexed_triangles& mesh = piece.mesh;
  mesh.points.assign(std::size_t(piece.vertices.size()), Vec3::Zero());
  mesh.exponent = exponent_of(partition.extent.maxCoeff());
  const double factor = std::ldexp(1., -mesh.exponent);
  ranks.together([&] {
    for(std::size_t row = partition.points.size(); row-- > 0;) // of copies the first one counts
      if(const int v = piece.vertex_of_row[row]; v >= 0)
      {
        mesh.points[std::size_t(v)] = factor * partition.points[row];
        if(!partition.points[row].allFinite() || partition.points[row].cwiseAbs().maxCoeff() > 1e150)
          throw Failure("vertex " + std::to_string(partition.file_vertices[row])
                        + ": a coordinate is NaN, infinite or too large");
      }
  });
  piece.vertices.update(mesh.points);
}

void set_triangles(const Ranks& ranks, std::vector<Triangle> triangles, Mesh_piece& piece)
{
  Indexed_triangles& mesh = piece.mesh;
  std::vector<Corners> local;
  for(Triangle& t : triangles)
  {
    Corners corners;
    for(std::size_t i = 0; i < 3; ++i)
      corners[i] = piece.vertices.local(t.vertices[i]);
    local.push_back(corners);
  }
  const auto lowest = [](const Corners& c) { return *std::min_element(c.begin(), c.end()); };
  std::vector<std::size_t> order(triangles.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return lowest(local[a]) < lowest(local[b]); });
  for(std::size_t k : order)
  {
    const Triangle& t = triangles[k];
    const bool is_near = lowest(local[k]) < piece.vertices.owned();
    std::array<int, 3> corners, rows{{0, 0, 0}};
    for(std::size_t i = 0; i < 3; ++i)
    {
      corners[i] = int(local[k][i]);
      if(is_near)
        rows[i] = piece.rows.local(t.rows[i]);
    }
    mesh.triangles.push_back(corners);
    mesh.rows.push_back(rows);
    piece.is_near.push_back(is_near);
    piece.is_counted.push_back(owner(piece.vertices.first_of_ranks(), lowest(t.vertices)) == ranks.rank());
  }
  mesh.index_corners();
}

} // namespace

Mesh_piece make_piece(const Ranks& ranks, Partition& partition, bool welds, int layers)
{
  Mesh_piece piece;
  piece.rows = make_halo(ranks, partition.first_row, partition.triangles,
                         [](const Row_triangle& t) -> const Corners& { return t.rows; });
  std::vector<Global> first_vertex;
  const std::vector<Global> vertex_of_row = number_vertices(ranks, partition, welds, piece, first_vertex);
  std::vector<Triangle> triangles;
  ranks.together([&] {
    triangles.reserve(partition.triangles.size());
    for(const Row_triangle& t : partition.triangles)
    {
      triangles.push_back({t.face, {}, t.rows});
      for(std::size_t i = 0; i < 3; ++i)
        triangles.back().vertices[i] = vertex_of_row[std::size_t(piece.rows.local(t.rows[i]))];
    }
  });
  partition.triangles = std::vector<Row_triangle>();
  if(layers > 1)
  {
    const std::vector<Triangle> own = triangles;
    for(int layer = 1; layer < layers; ++layer)
      add_layer(ranks, first_vertex, own, triangles);
  }
  piece.vertices = make_halo(ranks, first_vertex, triangles,
                             [](const Triangle& t) -> const Corners& { return t.vertices; });
  set_points(ranks, partition, piece);
  ranks.together([&] { set_triangles(ranks, std::move(triangles), piece); });
  for(int v = 0; v < piece.rows.size(); ++v)
    piece.mesh.vertex_of_row.push_back(
      vertex_of_row[std::size_t(v)] < 0 ? 0 : piece.vertices.local(vertex_of_row[std::size_t(v)]));
  return piece;
}
