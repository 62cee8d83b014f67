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
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

// Connects polygons that form an oriented manifold. Much faster than adding one face after the other, as the halfedges at a
// vertex are found once for all of them.
class Connector
{
  const Polygon_soup& m_soup;
  Mesh& m_mesh;
  std::vector<std::size_t> m_halfedge; // by corner: the one that leaves it

  static constexpr std::size_t none = std::size_t(-1);

public:
  Connector(const Polygon_soup& soup, Mesh& mesh) : m_soup(soup), m_mesh(mesh) {}

  // Empty if all went well, else what is wrong.
  std::string connect()
  {
    const std::vector<std::size_t> next = next_corners();
    std::string problem = check_polygons();
    if(problem.empty())
      problem = number_halfedges(next);
    if(problem.empty())
      problem = link(next);
    return problem;
  }

private:
  typedef Mesh::Vertex_index Vertex_index;
  typedef Mesh::Halfedge_index Halfedge_index;
  typedef Mesh::Face_index Face_index;

  static std::string name(const char* what, std::size_t i) { return what + (" " + std::to_string(i)); }

  std::vector<std::size_t> next_corners() const
  {
    std::vector<std::size_t> next(m_soup.corners.size());
    for(std::size_t f = 0; f < m_soup.number_of_polygons(); ++f)
    {
      const std::size_t begin = m_soup.first_corner[f], end = m_soup.first_corner[f + 1];
      for(std::size_t c = begin; c < end; ++c)
        next[c] = c + 1 < end ? c + 1 : begin;
    }
    return next;
  }

  std::string check_polygons() const
  {
    std::vector<int> sorted;
    for(std::size_t f = 0; f < m_soup.number_of_polygons(); ++f)
    {
      sorted.assign(m_soup.corners.begin() + std::ptrdiff_t(m_soup.first_corner[f]),
                    m_soup.corners.begin() + std::ptrdiff_t(m_soup.first_corner[f + 1]));
      if(sorted.size() < 3)
        return name("face", f) + " has less than three vertices";
      std::sort(sorted.begin(), sorted.end());
      if(std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
        return name("face", f) + " has a vertex twice";
    }
    return std::string();
  }

  // The corners in buckets by the smaller end of their edge, in which partners are looked for.
  std::string number_halfedges(const std::vector<std::size_t>& next)
  {
    const std::vector<int>& v = m_soup.corners;
    std::vector<std::size_t> offsets(m_soup.points.size() + 1, 0), sorted(v.size());
    const auto smaller = [&](std::size_t c) { return (std::min)(v[c], v[next[c]]); };
    const auto larger = [&](std::size_t c) { return (std::max)(v[c], v[next[c]]); };
    for(std::size_t c = 0; c < v.size(); ++c)
      ++offsets[std::size_t(smaller(c)) + 1];
    for(std::size_t i = 1; i < offsets.size(); ++i)
      offsets[i] += offsets[i - 1];
    {
      std::vector<std::size_t> at(offsets.begin(), offsets.end() - 1);
      for(std::size_t c = 0; c < v.size(); ++c)
        sorted[at[smaller(c)]++] = c;
    }

    m_halfedge.assign(v.size(), none);
    std::vector<std::size_t> first_of_edge;
    for(std::size_t i = 0; i + 1 < offsets.size(); ++i)
    {
      const auto begin = sorted.begin() + std::ptrdiff_t(offsets[i]), end = sorted.begin() + std::ptrdiff_t(offsets[i + 1]);
      if(end - begin > 32) // few vertices have many edges, but one may have them all
        std::stable_sort(begin, end, [&](std::size_t a, std::size_t b) { return larger(a) < larger(b); });
      for(auto c = begin; c != end; ++c)
      {
        if(m_halfedge[*c] != none)
          continue;
        const std::size_t edge = first_of_edge.size();
        first_of_edge.push_back(*c);
        m_halfedge[*c] = 2 * edge;
        bool has_partner = false;
        for(auto other = c + 1; other != end; ++other)
        {
          if(larger(*other) != larger(*c))
          {
            if(end - begin > 32)
              break;
            continue;
          }
          const std::string which = "the edge " + std::to_string(v[*c]) + "-" + std::to_string(v[next[*c]]);
          if(has_partner)
            return which + " has more than two faces";
          if(v[*other] == v[*c])
            return which + " is used twice in the same direction";
          m_halfedge[*other] = 2 * edge + 1;
          has_partner = true;
        }
      }
    }
    if(first_of_edge.size() > std::size_t((std::numeric_limits<int>::max)()) / 2)
      return "too many edges";

    m_mesh.resize(Mesh::size_type(m_soup.points.size()), Mesh::size_type(first_of_edge.size()),
                  Mesh::size_type(m_soup.number_of_polygons()));
    for(std::size_t i = 0; i < m_soup.points.size(); ++i)
      m_mesh.point(Vertex_index(Mesh::size_type(i))) = m_soup.points[i];
    for(std::size_t e = 0; e < first_of_edge.size(); ++e)
    {
      const std::size_t c = first_of_edge[e];
      m_mesh.set_target(halfedge(2 * e), Vertex_index(v[next[c]]));
      m_mesh.set_target(halfedge(2 * e + 1), Vertex_index(v[c]));
    }
    return std::string();
  }

  std::string link(const std::vector<std::size_t>& next)
  {
    for(std::size_t f = 0; f < m_soup.number_of_polygons(); ++f)
    {
      const Face_index face = Face_index(Mesh::size_type(f));
      for(std::size_t c = m_soup.first_corner[f]; c < m_soup.first_corner[f + 1]; ++c)
      {
        const Halfedge_index h = halfedge(m_halfedge[c]);
        m_mesh.set_face(h, face);
        m_mesh.set_next(h, halfedge(m_halfedge[next[c]]));
        m_mesh.set_halfedge(m_mesh.target(h), h);
      }
      m_mesh.set_halfedge(face, halfedge(m_halfedge[m_soup.first_corner[f + 1] - 1]));
    }

    std::vector<Halfedge_index> leaving_border(m_soup.points.size(), Mesh::null_halfedge());
    for(Halfedge_index h : m_mesh.halfedges())
      if(m_mesh.face(h) == Mesh::null_face())
      {
        Halfedge_index& leaving = leaving_border[std::size_t(m_mesh.source(h))];
        if(leaving != Mesh::null_halfedge())
          return several_umbrellas(m_mesh.source(h));
        leaving = h;
      }
    for(Halfedge_index h : m_mesh.halfedges())
      if(m_mesh.face(h) == Mesh::null_face())
      {
        m_mesh.set_next(h, leaving_border[std::size_t(m_mesh.target(h))]);
        m_mesh.set_halfedge(m_mesh.target(h), h); // a border vertex knows its border
      }

    std::vector<int> degree(m_soup.points.size(), 0);
    for(int v : m_soup.corners)
      ++degree[v];
    for(Vertex_index v : m_mesh.vertices())
    {
      int found = 0;
      if(m_mesh.halfedge(v) != Mesh::null_halfedge())
        for(Halfedge_index h : m_mesh.halfedges_around_target(m_mesh.halfedge(v)))
          found += m_mesh.face(h) != Mesh::null_face();
      if(found != degree[std::size_t(v)])
        return several_umbrellas(v);
    }
    return std::string();
  }

  static Halfedge_index halfedge(std::size_t i) { return Halfedge_index(Mesh::size_type(i)); }
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

  file.vertex_columns = std::move(soup.vertex_columns);
  file.face_columns = std::move(soup.face_columns);
  file.notes = std::move(soup.notes);
  for(Mesh::Face_index f : file.mesh.faces())
    if(file.mesh.degree(f) != 3)
    {
      if(!options.triangulate)
        throw Failure(path, "face " + std::to_string(std::size_t(f)) + " is not a triangle (--triangulate splits such faces)");
      if(!PMP::triangulate_faces(file.mesh))
        throw Failure(path, "a face cannot be triangulated");
      if(!file.face_columns.empty())
        file.notes.push_back("face properties, as faces were split");
      file.face_columns.clear();
      file.mesh.collect_garbage();
      break;
    }
  return file;
}
