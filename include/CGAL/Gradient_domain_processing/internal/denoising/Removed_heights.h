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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_REMOVED_HEIGHTS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_REMOVED_HEIGHTS_H

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

// What the passes took away, as heights along normals: r = (input - points) n. Of noise, it is uncorrelated from vertex
// to vertex; of detail, it is not. So what a smoothing S of a few steps, x -> (x + mean of neighbors) / 2, leaves of r
// is detail, as far as its mean square E around a vertex is above that of noise, N = t variance(r): the vertex gets (1
// - N / E) S r back.
class Removed_heights
{
  const Lists& m_rings;
  bool m_parallel;
  std::vector<double> m_heights, m_energies, m_next;

public:
  Removed_heights(const Lists& rings, bool parallel)
    : m_rings(rings), m_parallel(parallel), m_heights(std::size_t(rings.size())), m_next(m_heights.size())
  {}

  void measure(const std::vector<Vec3>& input, const std::vector<Vec3>& points, const std::vector<Vec3>& normals)
  {
    parallel_for(m_parallel, points.size(),
                 [&](std::size_t v) { m_heights[v] = (input[v] - points[v]).dot(normals[v]); });
  }

  // of neighbors
  double correlation() const
  {
    typedef Eigen::Vector2d Sums; // of squares and products
    const std::size_t n = m_heights.size();
    const Sums sums = sum_over_blocks(m_parallel, n, 4096, Sums(0, 0), [&](std::size_t begin, std::size_t end) {
      Sums part(0, 0);
      for(std::size_t v = begin; v < end; ++v)
      {
        double around = 0;
        for(const int* w = m_rings.begin(int(v)); w != m_rings.end(int(v)); ++w)
          around += m_heights[*w] / m_rings.size(int(v));
        part += m_heights[v] * Sums(m_heights[v], around);
      }
      return part;
    });
    return sums[0] > 0 ? sums[1] / sums[0] : 0;
  }

  // may_move(v); the measured heights are used up.
  template <class May_move>
  void give_back_detail(const May_move& may_move, double threshold, const std::vector<Vec3>& normals,
                        std::vector<Vec3>& points)
  {
    const double of_noise = threshold * clip(may_move);
    smooth(denoising::detail_steps, m_heights);
    m_energies.resize(m_heights.size());
    parallel_for(m_parallel, m_heights.size(), [&](std::size_t v) { m_energies[v] = m_heights[v] * m_heights[v]; });
    smooth(denoising::detail_window, m_energies);
    parallel_for(m_parallel, points.size(), [&](std::size_t v) {
      if(may_move(int(v)) && m_energies[v] > of_noise)
        points[v] += (1 - of_noise / m_energies[v]) * m_heights[v] * normals[v];
    });
  }

private:
  // Impulses count no more than noise does; answers the variance.
  template <class May_move>
  double clip(const May_move& may_move)
  {
    std::vector<double> magnitudes;
    for(std::size_t v = 0; v < m_heights.size(); ++v)
      if(may_move(int(v)))
        magnitudes.push_back(std::abs(m_heights[v]));
      else
        m_heights[v] = 0;
    if(magnitudes.empty())
      return 0;
    const double count = double(magnitudes.size());
    constexpr double deviation_by_median = 1.4826; // of a normal distribution
    const double most = denoising::detail_clip * deviation_by_median * median(std::move(magnitudes));
    double squares = 0;
    for(double& h : m_heights)
    {
      h = (std::max)(-most, (std::min)(most, h));
      squares += h * h;
    }
    return squares / count;
  }

  void smooth(int steps, std::vector<double>& x)
  {
    for(int k = 0; k < steps; ++k)
    {
      parallel_for(m_parallel, x.size(), [&](std::size_t v) {
        double sum = 0;
        for(const int* w = m_rings.begin(int(v)); w != m_rings.end(int(v)); ++w)
          sum += x[*w];
        m_next[v] = m_rings.size(int(v)) > 0 ? (x[v] + sum / m_rings.size(int(v))) / 2 : x[v];
      });
      x.swap(m_next);
    }
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_REMOVED_HEIGHTS_H
