// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Painting.h"

#include <algorithm>
#include <numeric>

Painting::Painting(const std::vector<Point>& points, const Polygons& polygons)
  : m_first_neighbor(points.size() + 1, 0), m_neighbors(2 * polygons.corners.size())
{
  const auto for_each_edge = [&](const auto& visit) {
    for(const auto& polygon : polygons)
      for(std::size_t i = 0; i < polygon.size(); ++i)
        visit(polygon[i], polygon[(i + 1) % polygon.size()]);
  };
  for_each_edge([&](int a, int b) {
    ++m_first_neighbor[std::size_t(a) + 1];
    ++m_first_neighbor[std::size_t(b) + 1];
  });
  std::partial_sum(m_first_neighbor.begin(), m_first_neighbor.end(), m_first_neighbor.begin());
  std::vector<std::size_t> end(m_first_neighbor.begin(), m_first_neighbor.end() - 1);
  for_each_edge([&](int a, int b) {
    m_neighbors[end[std::size_t(a)]++] = b;
    m_neighbors[end[std::size_t(b)]++] = a;
  });
}

bool Painting::dab(Brush brush, const std::vector<Point>& points, const Point& center, double radius, bool is_painted)
{
  std::vector<char>& paint = m_painted[std::size_t(brush)];
  const auto nearer = [&](const Point& p, const Point& q) { return CGAL::compare_distance(center, p, q) < 0; };
  const auto nearest = std::min_element(points.begin(), points.end(), nearer);
  if(nearest == points.end() || (paint.empty() && !is_painted))
    return false;
  paint.resize(points.size(), 0);
  bool has_changed = false;
  std::vector<char> is_reached(points.size(), 0);
  std::vector<int> front = {int(nearest - points.begin())};
  is_reached[std::size_t(front[0])] = 1;
  while(!front.empty())
  {
    const std::size_t v = std::size_t(front.back());
    front.pop_back();
    has_changed |= (paint[v] != 0) != is_painted;
    paint[v] = is_painted;
    for(std::size_t i = m_first_neighbor[v]; i < m_first_neighbor[v + 1]; ++i)
    {
      const std::size_t w = std::size_t(m_neighbors[i]);
      if(!is_reached[w] && CGAL::squared_distance(center, points[w]) <= radius * radius)
      {
        is_reached[w] = 1;
        front.push_back(int(w));
      }
    }
  }
  if(std::none_of(paint.begin(), paint.end(), [](char x) { return x != 0; }))
    paint.clear();
  return has_changed;
}

void Painting::wipe_off()
{
  for(std::vector<char>& paint : m_painted)
    paint.clear();
}

bool Painting::has_any() const
{
  return std::any_of(m_painted.begin(), m_painted.end(), [](const auto& paint) { return !paint.empty(); });
}
