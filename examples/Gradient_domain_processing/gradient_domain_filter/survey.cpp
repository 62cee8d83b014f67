// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Survey.h"
#include "files/Value_index.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace {

class Surveyor
{
  const std::vector<Point>& m_points;
  const Polygons& m_polygons;
  Survey m_survey;
  std::vector<char> m_is_on_border;
  std::vector<int> m_parent; // of vertices that are joined

public:
  Surveyor(const std::vector<Point>& points, const Polygons& polygons)
    : m_points(points), m_polygons(polygons), m_is_on_border(points.size(), 0), m_parent(points.size()) {}

  Survey survey()
  {
    m_survey.vertices = m_points.size();
    m_survey.faces = m_polygons.size();
    count_edges();
    count_seams();
    measure_components();
    return m_survey;
  }

private:
  // The faces of an edge meet in the bucket of its smaller end.
  void count_edges()
  {
    std::vector<std::uint32_t> begin(m_points.size() + 1, 0);
    for_each_edge([&](int v, int w) { ++begin[std::size_t((std::min)(v, w)) + 1]; });
    for(std::size_t v = 0; v < m_points.size(); ++v)
      begin[v + 1] += begin[v];
    std::vector<int> other(begin.back());
    {
      std::vector<std::uint32_t> at(begin.begin(), begin.end() - 1);
      for_each_edge([&](int v, int w) { other[at[std::size_t((std::min)(v, w))]++] = (std::max)(v, w); });
    }
    for(std::size_t v = 0; v < m_points.size(); ++v)
    {
      std::sort(other.begin() + begin[v], other.begin() + begin[v + 1]);
      for(std::uint32_t i = begin[v], next; i < begin[v + 1]; i = next)
      {
        for(next = i + 1; next < begin[v + 1] && other[next] == other[i]; ++next)
          ;
        ++m_survey.edges;
        m_survey.crowded_edges += next - i > 2;
        if(next - i == 1)
        {
          ++m_survey.border_edges;
          m_is_on_border[v] = m_is_on_border[std::size_t(other[i])] = 1;
        }
      }
    }
  }

  template <class Visit>
  void for_each_edge(const Visit& visit) const
  {
    for(std::size_t f = 0; f < m_polygons.size(); ++f)
    {
      const auto polygon = m_polygons[f];
      for(std::ptrdiff_t i = 0, n = std::ptrdiff_t(polygon.size()); i < n; ++i)
        visit(polygon[i], polygon[i + 1 < n ? i + 1 : 0]);
    }
  }

  int root(int v)
  {
    while(m_parent[std::size_t(v)] != v)
      v = m_parent[std::size_t(v)] = m_parent[std::size_t(m_parent[std::size_t(v)])];
    return v;
  }

  void join(int v, int w)
  {
    v = root(v);
    w = root(w);
    m_parent[std::size_t((std::max)(v, w))] = (std::min)(v, w);
  }

  // Copies of a border vertex join what they belong to.
  void count_seams()
  {
    std::iota(m_parent.begin(), m_parent.end(), 0);
    std::vector<int> first;
    std::vector<std::size_t> copies;
    Value_index<3> places(1024);
    for(std::size_t v = 0; v < m_points.size(); ++v)
      if(m_is_on_border[v])
      {
        const std::size_t place = std::size_t(places.find_or_add({{m_points[v].x(), m_points[v].y(), m_points[v].z()}}));
        if(place == first.size())
        {
          first.push_back(int(v));
          copies.push_back(0);
        }
        ++copies[place];
        join(first[place], int(v));
      }
    for(std::size_t n : copies)
      m_survey.seam_vertices += n > 1 ? n : 0;
  }

  void measure_components()
  {
    for(std::size_t f = 0; f < m_polygons.size(); ++f)
      for(int v : m_polygons[f])
        join(m_polygons[f][0], v);
    const double infinity = std::numeric_limits<double>::infinity();
    struct Component { std::size_t faces = 0; std::array<double, 3> low, high; };
    std::vector<Component> components(m_points.size());
    std::vector<char> is_used(m_points.size(), 0);
    for(std::size_t f = 0; f < m_polygons.size(); ++f)
    {
      if(m_polygons[f].empty())
        continue;
      Component& component = components[std::size_t(root(m_polygons[f][0]))];
      if(component.faces++ == 0)
      {
        component.low.fill(infinity);
        component.high.fill(-infinity);
      }
      for(int v : m_polygons[f])
        for(std::size_t i = 0; i < 3; ++i)
        {
          const double x = m_points[std::size_t(v)][int(i)];
          component.low[i] = (std::min)(component.low[i], x);
          component.high[i] = (std::max)(component.high[i], x);
          is_used[std::size_t(v)] = 1;
        }
      m_survey.area += area(m_polygons[f]);
    }
    m_survey.unused_vertices = std::size_t(std::count(is_used.begin(), is_used.end(), 0));
    m_survey.smallest_extent = infinity;
    for(const Component& component : components)
      if(component.faces > 0)
      {
        double extent = 0;
        for(std::size_t i = 0; i < 3; ++i)
          extent = (std::max)(extent, component.high[i] - component.low[i]);
        ++m_survey.components;
        m_survey.lone_faces += component.faces == 1;
        m_survey.smallest_extent = (std::min)(m_survey.smallest_extent, extent);
        m_survey.largest_extent = (std::max)(m_survey.largest_extent, extent);
      }
  }

  template <class Polygon>
  double area(const Polygon& polygon) const
  {
    Vector sum(0, 0, 0);
    const Point& a = m_points[std::size_t(polygon[0])];
    for(std::ptrdiff_t i = 2; i < std::ptrdiff_t(polygon.size()); ++i)
      sum = sum + CGAL::cross_product(m_points[std::size_t(polygon[i - 1])] - a, m_points[std::size_t(polygon[i])] - a);
    return std::sqrt(sum.squared_length()) / 2;
  }
};

std::string counted(std::size_t n, const std::string& one, const std::string& many)
{
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

} // namespace

std::vector<std::string> Survey::remarks(bool seams_are_welded) const
{
  std::vector<std::string> remarks;
  if(seam_vertices > 0 && !seams_are_welded) // else the library says so
    remarks.push_back(counted(seam_vertices, "border vertex", "border vertices")
                      + " at the same place as others are not one, as --no-weld says: such seams open");
  if(crowded_edges > 0)
    remarks.push_back(counted(crowded_edges, "edge", "edges") + " with more than two faces, which stay together");
  if(components > 1 && smallest_extent < largest_extent / 10)
    remarks.push_back(counted(components, "part", "parts") + " of very different size under one weight: the smallest is "
                      + std::to_string(int(std::round(largest_extent / (std::max)(smallest_extent, largest_extent * 1e-6))))
                      + " times smaller than the largest and changes most");
  if(lone_faces > 0 && faces > 1)
    remarks.push_back(counted(lone_faces, "face that is", "faces that are") + " connected to no other");
  if(unused_vertices > 0)
    remarks.push_back(counted(unused_vertices, "vertex", "vertices") + " without a face, left as they are");
  return remarks;
}

Survey survey(const std::vector<Point>& points, const Polygons& polygons)
{
  return Surveyor(points, polygons).survey();
}
