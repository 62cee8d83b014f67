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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_NOISE_CORRELATION_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_NOISE_CORRELATION_H

#include <CGAL/Gradient_domain_processing/internal/denoising/Face_geometry.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Noise_estimate.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/conjugate_gradients.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/constants.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// What an implicit smoothing with the uniform graph Laplacian takes away from every vertex, along its normal.
inline std::vector<double> fine_heights(const Lists& rings, const std::vector<Vec3>& points,
                                        const std::vector<Vec3>& normals, bool parallel)
{
  const std::size_t n = points.size();
  const double weight = denoising::fine_smoothing;
  std::vector<double> inverse_diagonal(n);
  std::vector<Vec3> right(n, Vec3(0, 0, 0)), change(n, Vec3(0, 0, 0));
  const auto difference = [&](const std::vector<Vec3>& p, int v) {
    Vec3 sum(0, 0, 0);
    for(const int* w = rings.begin(v); w != rings.end(v); ++w)
      sum += p[v] - p[*w];
    return sum;
  };
  parallel_for(parallel, n, [&](std::size_t v) {
    right[v] = -weight * difference(points, int(v));
    inverse_diagonal[v] = rings.size(int(v)) > 0 ? 1 / ((1 + weight) * rings.size(int(v))) : 0;
  });
  Conjugate_gradients<Vec3> solve(parallel);
  solve(
    [&](const std::vector<Vec3>& p, int v) { return Vec3(double(rings.size(v)) * p[v] + weight * difference(p, v)); },
    inverse_diagonal, right, 1e-3, denoising::most_solver_steps, change);
  std::vector<double> heights(n);
  parallel_for(parallel, n, [&](std::size_t v) { heights[v] = -normals[v].dot(change[v]); });
  return heights;
}

// The correlation of numbers on the vertices, clipped at 1 and 99 percent, at graph distances from 0 on, from a sample
// of them.
inline std::array<double, 5> correlation_by_distance(const Indexed_triangles& mesh, const Lists& rings,
                                                     std::vector<double> numbers)
{
  std::vector<double> sorted = numbers;
  const std::size_t n = sorted.size();
  const auto low = sorted.begin() + std::ptrdiff_t(n / 100), high = sorted.begin() + std::ptrdiff_t(n - 1 - n / 100);
  std::nth_element(sorted.begin(), low, sorted.end());
  const double least = *low;
  std::nth_element(sorted.begin(), high, sorted.end());
  const double most = *high;
  for(double& x : numbers)
    x = (std::max)(least, (std::min)(most, x));

  std::array<double, 5> sums{{0, 0, 0, 0, 0}}, counts = sums;
  std::vector<int> last_seen(n, -1), front, next;
  const int stride = (std::max)(1, int(n) / denoising::correlation_sample);
  for(int s = 0; s < int(n); s += stride)
  {
    if(mesh.is_on_border[s] || rings.size(s) == 0)
      continue;
    front.assign(1, s);
    last_seen[s] = s;
    for(std::size_t k = 0; k < sums.size(); ++k)
    {
      next.clear();
      for(int v : front)
      {
        sums[k] += numbers[s] * numbers[v];
        ++counts[k];
        for(const int* w = rings.begin(v); w != rings.end(v); ++w)
          if(last_seen[*w] != s)
          {
            last_seen[*w] = s;
            next.push_back(*w);
          }
      }
      front.swap(next);
    }
  }
  for(std::size_t k = 0; k < sums.size(); ++k)
    sums[k] /= (std::max)(1., counts[k]);
  const double variance = sums[0];
  for(double& s : sums)
    s = variance > 0 ? s / variance : 1;
  return sums;
}

// Shape decays slowly from distance to distance, white noise is at distance 0 alone. What stands at distance 1 above
// the geometric extrapolation from 2 and 4 is correlated noise.
inline double correlated_excess(const std::array<double, 5>& c)
{
  return c[1] - (c[2] > 0 && c[4] > 0 ? (std::min)(1., c[2] * std::sqrt(c[2] / c[4])) : (std::max)(0., c[2]));
}

// Whether angles between neighboring faces are large all over the mesh, not at a few creases only.
inline bool is_rough_all_over(std::vector<double>& angles)
{
  if(angles.empty())
    return false;
  const auto most = angles.begin() + std::ptrdiff_t(angles.size() * 4 / 5);
  std::nth_element(angles.begin(), most, angles.end());
  return *most >= denoising::least_rough_angle;
}

inline double root_mean_square(const std::vector<double>& numbers)
{
  double squares = 0;
  for(double x : numbers)
    squares += x * x;
  return numbers.empty() ? 0 : std::sqrt(squares / double(numbers.size()));
}

// Whether there is noise that is correlated from vertex to vertex, all over the mesh: a few creases look alike, and so
// do teeth that are a few edges thick, and what comes back after some edges.
inline bool has_correlated_noise(const Indexed_triangles& mesh, const Dual_graph& dual, const Lists& rings,
                                 const std::vector<Vec3>& points, const Face_geometry& faces, double mean_edge_length,
                                 bool parallel)
{
  std::vector<double> angles;
  dual.for_each_edge(mesh,
                     [&](int f, int g, int, int) { angles.push_back((faces.normals[f] - faces.normals[g]).norm()); });
  if(!is_rough_all_over(angles))
    return false;
  const std::vector<Vec3> normals = vertex_normals(mesh, faces.areas, faces.normals, parallel);
  const std::vector<double> heights = fine_heights(rings, points, normals, parallel);
  if(root_mean_square(heights) > denoising::highest_correlated_noise * mean_edge_length)
    return false;
  const std::array<double, 5> c = correlation_by_distance(mesh, rings, heights);
  const bool is_wave = (std::min)(c[3], c[4]) < denoising::least_correlation_of_noise
                    || c[4] > c[2] + denoising::most_return_of_noise;
  const bool has_planes = is_faceted(mesh, faces, dual, median(std::move(angles)));
  return c[1] < (has_planes ? denoising::most_correlation_of_steps : denoising::most_correlation_of_noise) && !is_wave
      && correlated_excess(c) > denoising::least_correlated_excess + 1 / std::sqrt(double(points.size()));
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_NOISE_CORRELATION_H
