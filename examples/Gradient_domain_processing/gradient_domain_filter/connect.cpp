// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Failure.h"
#include "Mesh_file.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

// Connects polygons that form an oriented manifold. Faster than adding one face after the other, as the halfedges are found
// for all vertices at once.
class Connector
{
  typedef std::uint32_t Corner; // index into the soup's corners
  typedef Mesh::Vertex_index Vertex_index;
  typedef Mesh::Halfedge_index Halfedge_index;
  typedef Mesh::Face_index Face_index;

  // The edge that leaves a corner, in the bucket of its smaller end.
  struct Side
  {
    int larger_end;
    Corner corner;
  };

  const Polygon_soup& m_soup;
  Mesh& m_mesh;
  std::vector<Halfedge_index> m_halfedge; // by corner: the one that leaves it

public:
  Connector(const Polygon_soup& soup, Mesh& mesh) : m_soup(soup), m_mesh(mesh) {}

  // Empty if all went well, else what is wrong.
  std::string connect()
  {
    std::string problem = check_polygons();
    if(problem.empty())
      problem = make_edges();
    if(problem.empty())
      problem = link();
    return problem;
  }

private:
  static std::string name(const char* what, std::size_t i) { return what + (" " + std::to_string(i)); }

  static std::string edge_name(std::size_t smaller_end, const Side& side)
  {
    return "the edge " + std::to_string(smaller_end) + "-" + std::to_string(side.larger_end);
  }

  // Calls visit(face, corner, next corner) for all corners.
  template <class Visit>
  void for_each_corner(const Visit& visit) const
  {
    for(std::size_t f = 0; f < m_soup.number_of_polygons(); ++f)
    {
      const Corner begin = Corner(m_soup.first_corner[f]), end = Corner(m_soup.first_corner[f + 1]);
      for(Corner c = begin; c < end; ++c)
        visit(f, c, c + 1 < end ? c + 1 : begin);
    }
  }

  std::string check_polygons() const
  {
    std::vector<int> sorted;
    for(std::size_t f = 0; f < m_soup.number_of_polygons(); ++f)
    {
      const int* const begin = m_soup.corners.data() + m_soup.first_corner[f];
      const int* const end = m_soup.corners.data() + m_soup.first_corner[f + 1];
      if(end - begin < 3)
        return name("face", f) + " has less than three vertices";
      bool is_repeated = begin[0] == begin[1] || begin[1] == begin[2] || begin[2] == begin[0];
      if(end - begin > 3)
      {
        sorted.assign(begin, end);
        std::sort(sorted.begin(), sorted.end());
        is_repeated = std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
      }
      if(is_repeated)
        return name("face", f) + " has a vertex twice";
    }
    return std::string();
  }

  // The two sides of an edge meet in the bucket of its smaller end.
  std::string make_edges()
  {
    const std::vector<int>& v = m_soup.corners;
    const std::size_t n = m_soup.points.size();
    std::vector<Corner> offsets(n + 1, 0);
    for_each_corner([&](std::size_t, Corner c, Corner next) { ++offsets[std::size_t((std::min)(v[c], v[next])) + 1]; });
    for(std::size_t i = 0; i < n; ++i)
      offsets[i + 1] += offsets[i];
    std::vector<Side> sides(v.size());
    {
      std::vector<Corner> at(offsets.begin(), offsets.end() - 1);
      for_each_corner([&](std::size_t, Corner c, Corner next) {
        sides[at[std::size_t((std::min)(v[c], v[next]))]++] = {(std::max)(v[c], v[next]), c};
      });
    }

    std::size_t edges = 0;
    for(std::size_t i = 0; i < n; ++i)
    {
      const auto begin = sides.begin() + std::ptrdiff_t(offsets[i]), end = sides.begin() + std::ptrdiff_t(offsets[i + 1]);
      std::sort(begin, end, [](const Side& a, const Side& b) {
        return a.larger_end != b.larger_end ? a.larger_end < b.larger_end : a.corner < b.corner;
      });
      for(auto side = begin; side != end; ++side, ++edges)
        if(side + 1 != end && side[1].larger_end == side->larger_end)
        {
          if(side + 2 != end && side[2].larger_end == side->larger_end)
            return edge_name(i, *side) + " has more than two faces";
          ++side;
          if(v[side[-1].corner] == v[side->corner])
            return edge_name(i, *side) + " is used twice in the same direction";
        }
    }
    if(edges > std::size_t((std::numeric_limits<int>::max)()) / 2)
      return "too many edges";

    m_mesh.resize(Mesh::size_type(n), Mesh::size_type(edges), Mesh::size_type(m_soup.number_of_polygons()));
    for(std::size_t i = 0; i < n; ++i)
      m_mesh.point(Vertex_index(Mesh::size_type(i))) = m_soup.points[i];
    m_halfedge.resize(v.size());
    Mesh::size_type h = 0;
    for(std::size_t i = 0; i < n; ++i)
      for(Corner k = offsets[i]; k < offsets[i + 1]; ++k, h += 2)
      {
        const Side side = sides[k];
        const int from = v[side.corner], to = from == int(i) ? side.larger_end : int(i);
        m_mesh.set_target(Halfedge_index(h), Vertex_index(Mesh::size_type(to)));
        m_mesh.set_target(Halfedge_index(h + 1), Vertex_index(Mesh::size_type(from)));
        m_halfedge[side.corner] = Halfedge_index(h);
        if(k + 1 < offsets[i + 1] && sides[k + 1].larger_end == side.larger_end)
          m_halfedge[sides[++k].corner] = Halfedge_index(h + 1);
      }
    return std::string();
  }

  std::string link()
  {
    for_each_corner([&](std::size_t f, Corner c, Corner next) {
      const Halfedge_index h = m_halfedge[c];
      m_mesh.set_face(h, Face_index(Mesh::size_type(f)));
      m_mesh.set_next(h, m_halfedge[next]);
      m_mesh.set_halfedge(Vertex_index(Mesh::size_type(m_soup.corners[next])), h);
      m_mesh.set_halfedge(Face_index(Mesh::size_type(f)), h); // the last of the face, as CGAL does
    });

    const std::size_t n = m_soup.points.size();
    std::vector<Halfedge_index> border, leaving(n, Mesh::null_halfedge());
    for(Halfedge_index h : m_mesh.halfedges())
      if(m_mesh.face(h) == Mesh::null_face())
      {
        const Vertex_index source = m_mesh.source(h);
        if(leaving[std::size_t(source)] != Mesh::null_halfedge())
          return several_umbrellas(source);
        leaving[std::size_t(source)] = h;
        border.push_back(h);
      }
    for(Halfedge_index h : border)
    {
      m_mesh.set_next(h, leaving[std::size_t(m_mesh.target(h))]);
      m_mesh.set_halfedge(m_mesh.target(h), h); // a border vertex knows its border
    }

    std::vector<int> degree(n, 0);
    for(int v : m_soup.corners)
      ++degree[std::size_t(v)];
    for(Vertex_index v : m_mesh.vertices())
    {
      const Halfedge_index first = m_mesh.halfedge(v);
      if(first == Mesh::null_halfedge())
        continue;
      int faces = m_mesh.face(first) != Mesh::null_face();
      for(Halfedge_index h = m_mesh.opposite(m_mesh.next(first)); h != first; h = m_mesh.opposite(m_mesh.next(h)))
        ++faces;
      if(faces != degree[std::size_t(v)])
        return several_umbrellas(v);
    }
    return std::string();
  }

  static std::string several_umbrellas(Vertex_index v)
  {
    return name("vertex", std::size_t(v)) + " joins parts that have no common edge there";
  }
};

// Repairs the soup until it is a manifold. Vertices are merged and copied meanwhile; each takes the columns of the first
// vertex of the file at the same place.
void repair(const std::string& path, Polygon_soup& soup)
{
  std::vector<Point> points = soup.points;
  std::vector<std::vector<std::size_t> > polygons;
  for(std::size_t f = 0; f < soup.number_of_polygons(); ++f)
    polygons.emplace_back(soup.corners.begin() + std::ptrdiff_t(soup.first_corner[f]),
                          soup.corners.begin() + std::ptrdiff_t(soup.first_corner[f + 1]));
  PMP::repair_polygon_soup(points, polygons);
  PMP::orient_polygon_soup(points, polygons);
  if(polygons.empty() || !PMP::is_polygon_soup_a_polygon_mesh(polygons))
    throw Failure(path, "cannot be repaired");

  std::vector<std::size_t> by_place(soup.points.size());
  for(std::size_t i = 0; i < by_place.size(); ++i)
    by_place[i] = i;
  std::stable_sort(by_place.begin(), by_place.end(), [&](std::size_t a, std::size_t b) { return soup.points[a] < soup.points[b]; });
  std::vector<std::size_t> origin;
  for(const Point& p : points)
    origin.push_back(*std::lower_bound(by_place.begin(), by_place.end(), p,
                                       [&](std::size_t i, const Point& q) { return soup.points[i] < q; }));

  Polygon_soup repaired;
  repaired.notes = std::move(soup.notes);
  if(!soup.face_columns.empty())
    repaired.notes.push_back("face properties, as the faces were repaired");
  for(Column& column : soup.vertex_columns)
  {
    repaired.vertex_columns.push_back({column.name, column.type, {}});
    for(std::size_t i : origin)
      repaired.vertex_columns.back().values.push_back(column.values[i]);
  }
  repaired.points = std::move(points);
  for(const auto& polygon : polygons)
  {
    for(std::size_t v : polygon)
      repaired.corners.push_back(int(v));
    repaired.close_polygon();
  }
  soup = std::move(repaired);
}

} // namespace

Mesh_file connect(const std::string& path, Polygon_soup& soup, const Read_options& options)
{
  for(std::size_t i = 0; i < soup.points.size(); ++i)
    for(int k = 0; k < 3; ++k)
      if(!std::isfinite(soup.points[i][k]))
        throw Failure(path, "vertex " + std::to_string(i) + " has a coordinate that is NaN or infinite");
  if(soup.number_of_polygons() == 0)
    throw Failure(path, "no faces");
  if(soup.points.size() > std::size_t((std::numeric_limits<int>::max)()) / 8)
    throw Failure(path, "too many vertices");

  Mesh_file file;
  std::string problem = Connector(soup, file.mesh).connect();
  if(!problem.empty() && options.repair)
  {
    repair(path, soup);
    file.mesh.clear();
    problem = Connector(soup, file.mesh).connect();
    file.notes.push_back("repaired");
  }
  if(!problem.empty())
    throw Failure(path, problem + "; not a manifold mesh" + (options.repair ? "" : " (--repair tries to make it one)"));

  for(std::size_t f = 0; f < soup.number_of_polygons(); ++f)
    if(soup.first_corner[f + 1] - soup.first_corner[f] != 3)
    {
      if(!options.triangulate)
        throw Failure(path, "face " + std::to_string(f) + " is not a triangle (--triangulate splits such faces)");
      split_polygons(path, soup);
      file.mesh.clear();
      problem = Connector(soup, file.mesh).connect();
      if(!problem.empty())
        throw Failure(path, "the faces cannot be split into triangles: " + problem);
      break;
    }
  file.vertex_columns = std::move(soup.vertex_columns);
  file.face_columns = std::move(soup.face_columns);
  file.notes.insert(file.notes.begin(), soup.notes.begin(), soup.notes.end());
  return file;
}
