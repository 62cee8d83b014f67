// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Survey.h"
#include "files/Value_index.h"
#include "files/file_blocks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

namespace {

class Surveyor
{
  const std::vector<Point>& m_points;
  const Polygons& m_polygons;
  bool m_counts_needles;
  Survey m_survey;
  std::vector<char> m_is_on_border, m_is_at_odd_edge;
  std::vector<int> m_parent; // of vertices that are joined

public:
  Surveyor(const std::vector<Point>& points, const Polygons& polygons, bool counts_needles)
    : m_points(points)
    , m_polygons(polygons)
    , m_counts_needles(counts_needles)
    , m_is_on_border(points.size(), 0)
    , m_is_at_odd_edge(points.size(), 0)
    , m_parent(points.size())
  {
  }

  Survey survey()
  {
    m_survey.vertices = m_points.size();
    m_survey.faces = m_polygons.size();
    count_edges();
    count_repeated_faces();
    count_seams();
    measure_parts();
    return m_survey;
  }

private:
  // The faces of an edge meet in the bucket of its smaller end, as the other end and the direction.
  void count_edges()
  {
    std::vector<std::uint32_t> begin(m_points.size() + 1, 0);
    for_each_edge([&](int v, int w) { ++begin[std::size_t((std::min)(v, w)) + 1]; });
    for(std::size_t v = 0; v < m_points.size(); ++v)
      begin[v + 1] += begin[v];
    std::vector<int> other(begin.back());
    {
      std::vector<std::uint32_t> at(begin.begin(), begin.end() - 1);
      for_each_edge([&](int v, int w) { other[at[std::size_t((std::min)(v, w))]++] = 2 * (std::max)(v, w) + (v < w); });
    }
    struct Block
    {
      std::size_t edges = 0, crowded = 0, flipped = 0, border = 0;
      std::vector<int> at_odd_edge, on_border; // vertices
    };
    std::vector<Block> blocks(m_points.size() / records_of_block + 1);
    for_each_block_of_records(m_points.size(), [&](std::size_t first, std::size_t last) {
      Block& block = blocks[first / records_of_block];
      for(std::size_t v = first; v < last; ++v)
      {
        std::sort(other.begin() + begin[v], other.begin() + begin[v + 1]);
        for(std::uint32_t i = begin[v], next; i < begin[v + 1]; i = next)
        {
          const int w = other[i] / 2;
          for(next = i + 1; next < begin[v + 1] && other[next] / 2 == w; ++next)
            ;
          const bool is_crowded = next - i > 2, is_flipped = next - i == 2 && other[i] == other[i + 1];
          ++block.edges;
          block.crowded += is_crowded;
          block.flipped += is_flipped;
          block.border += next - i == 1;
          if(is_crowded || is_flipped)
            block.at_odd_edge.insert(block.at_odd_edge.end(), {int(v), w});
          if(next - i == 1)
            block.on_border.insert(block.on_border.end(), {int(v), w});
        }
      }
    });
    for(const Block& block : blocks)
    {
      m_survey.edges += block.edges;
      m_survey.crowded_edges += block.crowded;
      m_survey.flipped_edges += block.flipped;
      m_survey.border_edges += block.border;
      for(int v : block.at_odd_edge)
        m_is_at_odd_edge[std::size_t(v)] = 1;
      for(int v : block.on_border)
        m_is_on_border[std::size_t(v)] = 1;
    }
  }

  // All edges of such a face are odd. Its vertices in any order have the same sum of scrambled numbers.
  void count_repeated_faces()
  {
    std::vector<std::uint64_t> sums;
    for(std::size_t f = 0; f < m_polygons.size(); ++f)
    {
      const auto polygon = m_polygons[f];
      if(!std::all_of(polygon.begin(), polygon.end(), [&](int v) { return m_is_at_odd_edge[std::size_t(v)] != 0; }))
        continue;
      std::uint64_t sum = 0;
      for(int v : polygon)
      {
        const std::uint64_t x = (std::uint64_t(v) + 1) * 0x9E3779B97F4A7C15u;
        sum += (x ^ (x >> 31)) * 0xBF58476D1CE4E5B9u;
      }
      sums.push_back(sum);
    }
    std::sort(sums.begin(), sums.end());
    m_survey.repeated_faces = std::size_t(sums.end() - std::unique(sums.begin(), sums.end()));
  }

  template <class Visit>
  void for_each_edge(const Visit& visit) const
  {
    const int* const corners = m_polygons.corners.data();
    for(std::size_t f = 0; f < m_polygons.size(); ++f)
    {
      const std::size_t begin = m_polygons.first_corner[f], end = m_polygons.first_corner[f + 1];
      int v = begin < end ? corners[end - 1] : 0;
      for(std::size_t i = begin; i < end; ++i)
      {
        const int w = corners[i];
        if(v != w)
          visit(v, w);
        v = w;
      }
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

  double longest_squared_edge(const Polygons::value_type& polygon) const
  {
    double longest = 0;
    for(std::ptrdiff_t i = 0, n = std::ptrdiff_t(polygon.size()); i < n; ++i)
    {
      const Point &p = m_points[std::size_t(polygon[i])], &q = m_points[std::size_t(polygon[i + 1 < n ? i + 1 : 0])];
      longest = (std::max)(longest, CGAL::squared_distance(p, q));
    }
    return longest;
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
        const std::size_t place =
          std::size_t(places.find_or_add({{m_points[v].x(), m_points[v].y(), m_points[v].z()}}));
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

  struct Box
  {
    std::array<double, 3> low, high;

    Box()
    {
      low.fill(std::numeric_limits<double>::infinity());
      high.fill(-std::numeric_limits<double>::infinity());
    }

    void add(const Point& p)
    {
      for(std::size_t i = 0; i < 3; ++i)
        if(const double x = p[int(i)]; std::isfinite(x))
        {
          low[i] = (std::min)(low[i], x);
          high[i] = (std::max)(high[i], x);
        }
    }

    double extent() const
    {
      double most = 0;
      for(std::size_t i = 0; i < 3; ++i)
        most = (std::max)(most, high[i] - low[i]);
      return most;
    }
  };

  void measure_parts()
  {
    std::vector<char> is_used(m_points.size(), 0);
    for(std::size_t f = 0; f < m_polygons.size(); ++f)
      for(int v : m_polygons[f])
      {
        is_used[std::size_t(v)] = 1;
        join(m_polygons[f][0], v);
      }
    std::vector<int> part_of_vertex(m_points.size(), -1);
    for(std::size_t f = 0; f < m_polygons.size(); ++f)
      if(!m_polygons[f].empty())
        if(int& part = part_of_vertex[std::size_t(root(m_polygons[f][0]))]; part < 0)
        {
          part = int(m_survey.parts.size());
          m_survey.parts.push_back({f, 0, 0.});
        }
    std::vector<Box> boxes(m_survey.parts.size());
    for(std::size_t v = 0; v < m_points.size(); ++v)
      if(is_used[v])
      {
        part_of_vertex[v] = part_of_vertex[std::size_t(root(int(v)))];
        boxes[std::size_t(part_of_vertex[v])].add(m_points[v]);
      }
    add_faces(part_of_vertex);
    m_survey.components = boxes.size();
    m_survey.unused_vertices = std::size_t(std::count(is_used.begin(), is_used.end(), 0));
    m_survey.smallest_extent = std::numeric_limits<double>::infinity();
    for(const Box& box : boxes)
    {
      m_survey.smallest_extent = (std::min)(m_survey.smallest_extent, box.extent());
      m_survey.largest_extent = (std::max)(m_survey.largest_extent, box.extent());
    }
    for(const Survey::Part& part : m_survey.parts)
      m_survey.lone_faces += part.faces == 1;
    if(boxes.size() > 1)
      m_survey.part_of_vertex = std::move(part_of_vertex);
  }

  void add_faces(const std::vector<int>& part_of_vertex)
  {
    std::vector<double> areas(m_polygons.size(), 0.);
    std::vector<char> is_needle(m_polygons.size(), 0);
    for_each_block_of_records(m_polygons.size(), [&](std::size_t begin, std::size_t end) {
      for(std::size_t f = begin; f < end; ++f)
        if(!m_polygons[f].empty())
        {
          areas[f] = area(m_polygons[f]);
          is_needle[f] = m_counts_needles && areas[f] > 0 && 40 * areas[f] < longest_squared_edge(m_polygons[f]);
        }
    });
    for(std::size_t f = 0; f < m_polygons.size(); ++f)
    {
      if(m_polygons[f].empty())
        continue;
      Survey::Part& part = m_survey.parts[std::size_t(part_of_vertex[std::size_t(m_polygons[f][0])])];
      m_survey.flat_faces += areas[f] == 0;
      m_survey.needles += std::size_t(is_needle[f]);
      m_survey.area += areas[f];
      part.area += areas[f];
      ++part.faces;
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

std::vector<std::string> Survey::remarks(bool seams_are_welded, bool near_ones_are_welded, bool has_one_weight) const
{
  std::vector<std::string> remarks;
  if(seam_vertices > 0 && !seams_are_welded) // else the library says so
    remarks.push_back(counted(seam_vertices, "border vertex", "border vertices")
                      + " at the same place as others are not one, as --no-weld says: such seams open");
  if(crowded_edges > 0)
    remarks.push_back(counted(crowded_edges, "edge", "edges") + " with more than two faces, which stay together");
  if(flipped_edges > 0)
    remarks.push_back(counted(flipped_edges, "edge", "edges") + " between faces of which one is turned over");
  if(repeated_faces > 0)
    remarks.push_back(counted(repeated_faces, "face that is", "faces that are")
                      + " there already, with the same vertices: such weigh twice");
  if(flat_faces > 0)
    remarks.push_back(counted(flat_faces, "face", "faces") + " without area");
  if(has_one_weight && !near_ones_are_welded && components > 1 && smallest_extent < largest_extent / 10)
    remarks.push_back(
      counted(components, "part", "parts") + " of very different size under one weight: the smallest is "
      + std::to_string(int(std::round(largest_extent / (std::max)(smallest_extent, largest_extent * 1e-6))))
      + " times smaller than the largest and changes most");
  if(lone_faces > 0 && faces > 1 && !near_ones_are_welded)
    remarks.push_back(counted(lone_faces, "face that is", "faces that are") + " connected to no other"
                      + (lone_faces > faces / 2 ? ": does a (larger) --weld-tolerance join them?" : ""));
  if(unused_vertices > 0)
    remarks.push_back(
      counted(unused_vertices, "vertex without a face stays as it is", "vertices without a face stay as they are"));
  return remarks;
}

Survey survey(const std::vector<Point>& points, const Polygons& polygons, bool counts_needles)
{
  return Surveyor(points, polygons, counts_needles).survey();
}
