// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "seams.h"
#include "files/Value_index.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace {

std::vector<char> border_vertices(std::size_t n, const Polygons& polygons)
{
  std::vector<std::pair<int, int> > edges;
  for(const auto& polygon : polygons)
    for(std::ptrdiff_t i = 0, size = std::ptrdiff_t(polygon.size()); i < size; ++i)
      if(const int v = polygon[i], w = polygon[i + 1 < size ? i + 1 : 0]; v != w)
        edges.emplace_back((std::min)(v, w), (std::max)(v, w));
  std::sort(edges.begin(), edges.end());
  std::vector<char> is_on_border(n, 0);
  for(std::size_t i = 0, next; i < edges.size(); i = next)
  {
    for(next = i + 1; next < edges.size() && edges[next] == edges[i]; ++next)
      ;
    if(next == i + 1)
      is_on_border[std::size_t(edges[i].first)] = is_on_border[std::size_t(edges[i].second)] = 1;
  }
  return is_on_border;
}

} // namespace

std::vector<int> first_in_place(const std::vector<Point>& points, const Polygons& polygons)
{
  std::vector<int> first(points.size()), first_of_place;
  std::iota(first.begin(), first.end(), 0);
  const std::vector<char> is_on_border = border_vertices(points.size(), polygons);
  Value_index<3> places(1024);
  for(std::size_t v = 0; v < points.size(); ++v)
    if(is_on_border[v])
    {
      const std::size_t place = std::size_t(places.find_or_add({{points[v].x(), points[v].y(), points[v].z()}}));
      if(place == first_of_place.size())
        first_of_place.push_back(int(v));
      first[v] = first_of_place[place];
    }
  return first;
}
