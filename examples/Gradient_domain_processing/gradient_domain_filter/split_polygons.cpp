// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Failure.h"
#include "Mesh_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_set>

namespace {

// Cuts polygons into triangles along diagonals that are no edges yet. Whatever the polygon is, of no area or crossing itself,
// the work is bounded by the square of its size, and every corner stays: triangles may then be empty or overlap.
class Polygon_splitter
{
  typedef std::array<double, 2> Point_2;

  static constexpr std::size_t tests_by_corner = 8;

  const std::vector<Point>& m_points;
  std::unordered_set<std::uint64_t> m_edges;
  std::vector<int> m_corners; // those that are left
  std::vector<Point_2> m_flat; // the same, projected to the plane of the polygon
  std::vector<double> m_quality; // of the triangle that each of them makes with its neighbors
  std::vector<char> m_is_blocked; // that triangle held another corner when it was tried
  std::vector<std::array<int, 3> > m_triangles;

public:
  explicit Polygon_splitter(const std::vector<Point>& points) : m_points(points) {}

  void add_edge(int v, int w) { m_edges.insert(key(v, w)); }

  const std::vector<std::array<int, 3> >& split(const int* begin, const int* end)
  {
    m_corners.assign(begin, end);
    m_triangles.clear();
    flatten();
    m_quality.clear();
    for(std::size_t i = 0; i < m_corners.size(); ++i)
      m_quality.push_back(quality(i));
    m_is_blocked.assign(m_corners.size(), 0);
    std::size_t tests = tests_by_corner * m_corners.size();
    while(m_corners.size() > 3)
      cut_off(m_corners.size() == 4 ? best_of_four() : best(tests));
    m_triangles.push_back({{m_corners[0], m_corners[1], m_corners[2]}});
    return m_triangles;
  }

private:
  static std::uint64_t key(int v, int w)
  {
    return (std::uint64_t((std::min)(v, w)) << 32) | std::uint64_t((std::max)(v, w));
  }

  std::size_t next(std::size_t i) const { return i + 1 < m_corners.size() ? i + 1 : 0; }
  std::size_t previous(std::size_t i) const { return (i > 0 ? i : m_corners.size()) - 1; }

  // Relative to the first corner and the extent, onto the plane across the sum of all normals.
  void flatten()
  {
    const Point& origin = m_points[std::size_t(m_corners[0])];
    std::vector<Vector> p;
    double extent = 0;
    for(int v : m_corners)
    {
      p.push_back(m_points[std::size_t(v)] - origin);
      for(int k = 0; k < 3; ++k)
        extent = (std::max)(extent, std::abs(p.back()[k]));
    }
    Vector normal(0, 0, 0);
    for(std::size_t i = 0; i < p.size(); ++i)
      p[i] = extent > 0 ? p[i] / extent : p[i];
    for(std::size_t i = 0; i < p.size(); ++i)
      normal = normal + CGAL::cross_product(p[i], p[next(i)]);

    // the axis that is farthest from the normal makes a well conditioned basis
    int axis = 0;
    for(int k = 1; k < 3; ++k)
      if(std::abs(normal[k]) < std::abs(normal[axis]))
        axis = k;
    const Vector u = unit(CGAL::cross_product(normal, Vector(axis == 0, axis == 1, axis == 2)));
    const Vector v = unit(CGAL::cross_product(normal, u));
    m_flat.clear();
    for(const Vector& q : p)
      m_flat.push_back({{q * u, q * v}});
  }

  static Vector unit(const Vector& v)
  {
    const double length = std::sqrt(v.squared_length());
    return length > 0 ? v / length : v;
  }

  static double area(const Point_2& a, const Point_2& b, const Point_2& c)
  {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }

  static double squared_distance(const Point_2& a, const Point_2& b)
  {
    return (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]);
  }

  // Area over squared lengths: negative if turned over, the least there is if the diagonal is an edge already.
  double quality(std::size_t a, std::size_t b, std::size_t c) const
  {
    const double lengths = squared_distance(m_flat[a], m_flat[b]) + squared_distance(m_flat[b], m_flat[c])
                           + squared_distance(m_flat[c], m_flat[a]);
    const double q = lengths > 0 ? area(m_flat[a], m_flat[b], m_flat[c]) / lengths : 0;
    return std::isnan(q) ? -1 : q;
  }
  double quality(std::size_t i) const
  {
    const std::size_t before = previous(i), after = next(i);
    return m_edges.count(key(m_corners[before], m_corners[after])) ? -std::numeric_limits<double>::infinity()
                                                                   : quality(before, i, after);
  }

  bool is_empty(std::size_t i) const
  {
    const std::size_t before = previous(i), after = next(i);
    const Point_2 &a = m_flat[before], &b = m_flat[i], &c = m_flat[after];
    for(std::size_t j = 0; j < m_corners.size(); ++j)
      if(j != before && j != i && j != after && area(a, b, m_flat[j]) >= 0 && area(b, c, m_flat[j]) >= 0 && area(c, a, m_flat[j]) >= 0)
        return false;
    return true;
  }

  // The best corner whose triangle holds no other; the best of all where there is none, or that was tried too often.
  std::size_t best(std::size_t& tests)
  {
    for(bool is_fresh = false; tests > 0;)
    {
      std::size_t found = m_corners.size();
      for(std::size_t i = 0; i < m_corners.size(); ++i)
        if(m_quality[i] > 0 && !m_is_blocked[i] && (found == m_corners.size() || m_quality[i] > m_quality[found]))
          found = i;
      if(found == m_corners.size())
      {
        if(is_fresh)
          break;
        is_fresh = true; // those in the way may be gone
        std::fill(m_is_blocked.begin(), m_is_blocked.end(), 0);
        continue;
      }
      --tests;
      if(is_empty(found))
        return found;
      m_is_blocked[found] = 1;
    }
    return std::size_t(std::max_element(m_quality.begin(), m_quality.end()) - m_quality.begin());
  }

  // Two diagonals only, so both triangles count.
  std::size_t best_of_four() const
  {
    const double first = (std::min)(quality(0), quality(2)), second = (std::min)(quality(1), quality(3));
    return second > first ? 1 : 0;
  }

  void cut_off(std::size_t i)
  {
    const int a = m_corners[previous(i)], c = m_corners[next(i)];
    m_triangles.push_back({{a, m_corners[i], c}});
    add_edge(a, c);
    m_corners.erase(m_corners.begin() + std::ptrdiff_t(i));
    m_flat.erase(m_flat.begin() + std::ptrdiff_t(i));
    m_quality.erase(m_quality.begin() + std::ptrdiff_t(i));
    m_is_blocked.erase(m_is_blocked.begin() + std::ptrdiff_t(i));
    const std::size_t after = i < m_corners.size() ? i : 0;
    for(std::size_t changed : {previous(after), after})
    {
      m_quality[changed] = quality(changed);
      m_is_blocked[changed] = 0;
    }
  }
};

} // namespace

void split_polygons(const std::string& path, Polygon_soup& soup)
{
  constexpr std::size_t most_corners = 10000;
  Polygon_splitter splitter(soup.points);
  for(std::size_t f = 0; f < soup.number_of_polygons(); ++f)
  {
    const std::size_t begin = soup.first_corner[f], end = soup.first_corner[f + 1];
    if(end - begin > most_corners)
      throw Failure(path, "face " + std::to_string(f) + " has " + std::to_string(end - begin) + " corners, too many to split it");
    for(std::size_t c = begin; c < end; ++c)
      splitter.add_edge(soup.corners[c], soup.corners[c + 1 < end ? c + 1 : begin]);
  }

  std::vector<int> corners;
  std::vector<std::size_t> first_corner = {0}, origin;
  for(std::size_t f = 0; f < soup.number_of_polygons(); ++f)
  {
    const int* const begin = soup.corners.data() + soup.first_corner[f];
    for(const auto& triangle : splitter.split(begin, soup.corners.data() + soup.first_corner[f + 1]))
    {
      corners.insert(corners.end(), triangle.begin(), triangle.end());
      first_corner.push_back(corners.size());
      origin.push_back(f);
    }
  }
  soup.corners = std::move(corners);
  soup.first_corner = std::move(first_corner);
  for(Column& column : soup.face_columns)
  {
    std::vector<double> values;
    for(std::size_t f : origin)
      values.push_back(column.values[f]);
    column.values = std::move(values);
  }
}
