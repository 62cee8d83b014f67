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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_OUTLIERS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_OUTLIERS_H

#include <CGAL/Gradient_domain_processing/internal/denoising/Face_geometry.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/constants.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Vertices far outside of where their neighbors are, at the scale of those: spikes. The area-weighted normal of a
// vertex does not depend on its position, nor does the median of its neighbors' heights along it.
class Outliers
{
  const Indexed_triangles& m_mesh;
  const Lists& m_rings;
  bool m_parallel;
  std::vector<double> m_heights; // of a vertex above the median of its neighbors
  std::vector<double> m_sides;   // median length of the edges between neighbors

public:
  std::vector<char> is_outlier;
  std::size_t size = 0;

  Outliers(const Indexed_triangles& mesh, const Lists& rings, const std::vector<Vec3>& points, bool parallel)
    : m_mesh(mesh), m_rings(rings), m_parallel(parallel), m_heights(points.size(), 0), m_sides(points.size(), 0)
    , is_outlier(points.size(), 0)
  {
    measure(points);
    find();
  }

  // They go to the mean of their neighbors, as high above it as those are above theirs.
  void repair(const std::vector<char>& is_constrained, std::vector<Vec3>& points) const
  {
    std::vector<int> outliers;
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(is_outlier[v] && !is_constrained[v])
        outliers.push_back(v);
    std::vector<Vec3> moved(outliers.size());
    for(int step = 0; step < denoising::outlier_steps; ++step)
    {
      parallel_for(m_parallel, outliers.size(), [&](std::size_t i) { moved[i] = place(outliers[i], step, points); });
      for(std::size_t i = 0; i < outliers.size(); ++i)
        points[outliers[i]] = moved[i];
    }
  }

private:
  Vec3 normal(int v, const std::vector<Vec3>& points) const
  {
    Vec3 sum(0, 0, 0);
    for(const int* c = m_mesh.corners.begin(v); c != m_mesh.corners.end(v); ++c)
    {
      const auto others = m_mesh.opposite_vertices(*c);
      sum += (points[others[0]] - points[v]).cross(points[others[1]] - points[v]);
    }
    const double length = sum.norm();
    return length > 0 ? Vec3(sum / length) : Vec3(0, 0, 0);
  }

  Vec3 place(int v, int step, const std::vector<Vec3>& points) const
  {
    Vec3 mean(0, 0, 0);
    double height = 0;
    int regular = 0;
    for(const int* w = m_rings.begin(v); w != m_rings.end(v); ++w)
      if(!is_outlier[*w] || step > 0)
      {
        mean += points[*w];
        height += is_outlier[*w] ? 0 : m_heights[*w];
        ++regular;
      }
    return regular > 0 ? Vec3(mean / regular + height / regular * normal(v, points)) : points[v];
  }

  void measure(const std::vector<Vec3>& points)
  {
    parallel_for(m_parallel, points.size(), [&](std::size_t v) {
      if(m_mesh.is_on_border[v] || m_rings.size(int(v)) < 3)
        return;
      const Vec3 n = normal(int(v), points);
      std::vector<double> heights;
      for(const int* w = m_rings.begin(int(v)); w != m_rings.end(int(v)); ++w)
        heights.push_back(n.dot(points[v] - points[*w]));
      std::sort(heights.begin(), heights.end());
      m_heights[v] = (heights[(heights.size() - 1) / 2] + heights[heights.size() / 2]) / 2;
      std::vector<double> sides;
      for(const int* c = m_mesh.corners.begin(int(v)); c != m_mesh.corners.end(int(v)); ++c)
      {
        const auto others = m_mesh.opposite_vertices(*c);
        sides.push_back((points[others[0]] - points[others[1]]).norm());
      }
      m_sides[v] = median(std::move(sides));
    });
  }

  // Compared with the neighbors and theirs, in the median, and with the ring. Along a crease, and at a corner, more
  // than one neighbor stands out; beside other spikes, two may.
  bool stands_out(int v, double height, bool is_strong) const
  {
    std::vector<double> ring, all;
    for(const int* w = m_rings.begin(v); w != m_rings.end(v); ++w)
    {
      ring.push_back(std::abs(m_heights[*w]));
      for(const int* u = m_rings.begin(*w); u != m_rings.end(*w); ++u)
        if(*u != v)
          all.push_back(std::abs(m_heights[*u]));
    }
    std::sort(ring.rbegin(), ring.rend());
    return height > denoising::outlier_by_ring * ring[is_strong ? 2 : 1]
        && height > (is_strong ? denoising::strong_by_median : denoising::outlier_by_median) * median(std::move(all));
  }

  void find()
  {
    std::vector<char> grade(m_heights.size(), 0);
    parallel_for(m_parallel, m_heights.size(), [&](std::size_t v) {
      const double height = std::abs(m_heights[v]);
      if(height <= denoising::weak_outlier * m_sides[v])
        return;
      const bool is_strong = height > denoising::strong_outlier * m_sides[v];
      if(stands_out(int(v), height, is_strong))
        grade[v] = is_strong ? 2 : 1;
    });
    // a few weak ones may be tips that belong to the shape
    const std::size_t weak = std::size_t(std::count(grade.begin(), grade.end(), 1));
    const bool all = double(weak) > denoising::least_weak_share * double(grade.size());
    for(std::size_t v = 0; v < grade.size(); ++v)
      is_outlier[v] = grade[v] == 2 || (all && grade[v] == 1);
    size = std::size_t(std::count(is_outlier.begin(), is_outlier.end(), 1));
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_OUTLIERS_H
