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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_WELD_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_WELD_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/mesh/weld.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Disjoint_sets.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Joins vertices among `candidates` that are not further apart than the tolerance, 0 for those in the same place.
class Coincident_points
{
  struct Cell
  {
    std::array<std::int64_t, 3> at;
    bool operator==(const Cell& other) const { return at == other.at; }
  };
  struct Hash
  {
    std::size_t operator()(const Cell& c) const
    {
      std::uint64_t h = 0;
      for(std::int64_t x : c.at)
        h = (h ^ std::uint64_t(x)) * 0x9E3779B97F4A7C15u ^ (h >> 29);
      return std::size_t(h ^ (h >> 32));
    }
  };

  const std::vector<Vec3>& m_points;
  double m_tolerance;
  std::unordered_map<Cell, std::vector<int>, Hash> m_cells;

public:
  Coincident_points(const std::vector<Vec3>& points, double tolerance) : m_points(points), m_tolerance(tolerance) {}

  void join(const std::vector<int>& candidates, Disjoint_sets& sets)
  {
    for(int v : candidates)
    {
      const Cell cell = cell_of(m_points[v]);
      for_each_cell_around(cell, [&](const Cell& neighbor) {
        const auto found = m_cells.find(neighbor);
        if(found != m_cells.end())
          for(int w : found->second)
            if((m_points[v] - m_points[w]).norm() <= m_tolerance)
              sets.join(v, w);
      });
      m_cells[cell].push_back(v);
    }
  }

private:
  Cell cell_of(const Vec3& p) const
  {
    Cell cell;
    for(int i = 0; i < 3; ++i)
      if(m_tolerance > 0)
        cell.at[i] = std::int64_t(std::floor(p[i] / m_tolerance));
      else
      {
        const double x = p[i] + 0.; // one zero
        std::copy_n(reinterpret_cast<const unsigned char*>(&x), sizeof x,
                    reinterpret_cast<unsigned char*>(&cell.at[i]));
      }
    return cell;
  }

  template <class Visit>
  void for_each_cell_around(const Cell& c, const Visit& visit) const
  {
    if(!(m_tolerance > 0))
    {
      visit(c);
      return;
    }
    for(std::int64_t x = -1; x <= 1; ++x)
      for(std::int64_t y = -1; y <= 1; ++y)
        for(std::int64_t z = -1; z <= 1; ++z)
          visit(Cell{{{c.at[0] + x, c.at[1] + y, c.at[2] + z}}});
  }
};

// Points that no triangle uses may be anywhere. What is less than the digits of the coordinates is none.
CGAL_GDP_INLINE double length_of_tolerance(double tolerance, const Indexed_triangles& mesh)
{
  if(!(tolerance > 0))
    return 0;
  const double infinity = std::numeric_limits<double>::infinity();
  Vec3 low = Vec3::Constant(infinity), high = -low;
  for(const auto& t : mesh.triangles)
    for(int v : t)
    {
      low = low.cwiseMin(mesh.points[v]);
      high = high.cwiseMax(mesh.points[v]);
    }
  const double length = tolerance * (high - low).maxCoeff(),
               largest = (std::max)(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  return length > std::numeric_limits<double>::epsilon() * largest ? length : 0;
}

CGAL_GDP_INLINE int weld_border(double tolerance, Indexed_triangles& mesh)
{
  const int n = mesh.number_of_vertices();
  std::vector<int> candidates;
  for(int v = 0; v < n; ++v)
    if(mesh.is_on_border[v])
      candidates.push_back(v);
  if(candidates.empty())
    return 0;
  Disjoint_sets sets(n);
  Coincident_points(mesh.points, length_of_tolerance(tolerance, mesh)).join(candidates, sets);

  std::vector<int> number(n, -1);
  mesh.vertex_of_row.resize(n);
  int count = 0;
  for(int v = 0; v < n; ++v) // virtual vertices stay the last
  {
    const int root = sets.root(v);
    if(number[root] < 0)
    {
      mesh.points[count] = mesh.points[v];
      number[root] = count++;
    }
    mesh.vertex_of_row[v] = number[root];
  }
  if(count == n)
  {
    mesh.vertex_of_row.clear();
    return 0;
  }
  mesh.points.resize(count);
  mesh.rows = mesh.triangles;
  for(auto& t : mesh.triangles)
    for(int& v : t)
      v = mesh.vertex_of_row[v];
  return n - count;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_WELD_IMPL_H
