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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_NOISE_ESTIMATE_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_NOISE_ESTIMATE_H

#include <CGAL/Gradient_domain_processing/internal/denoising/Face_geometry.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// What the positions tell of the noise on them.
struct Noise_estimate
{
  double level = 0;             // of face normals, in radians; zero for a clean mesh
  double share = 1;             // of the roughness: noise rather than detail
  double roughness_level = 0;   // the level, if all roughness were noise
  double border_variance = 1;   // of the noise at the border, relative to that inside
  double border_level = 1;      // of face normals at the border, relative to that of all; at most one
};

// How alike pairs of numbers are: 1 for equal ones, -1 for opposite ones. Medians do not see creases, means do not
// overlook noise on a few vertices.
class Pair_correlation
{
  std::vector<double> m_differences, m_sums;

  static double compare(double difference, double sum)
  {
    const double d = difference * difference, s = sum * sum;
    return s + d > 0 ? (s - d) / (s + d) : 1;
  }

public:
  void insert(double a, double b)
  {
    m_differences.push_back(std::abs(a - b));
    m_sums.push_back(std::abs(a + b));
  }

  double of_medians() const { return compare(median(m_differences), median(m_sums)); }

  double of_means() const
  {
    return compare(std::accumulate(m_differences.begin(), m_differences.end(), 0.),
                   std::accumulate(m_sums.begin(), m_sums.end(), 0.));
  }
};

constexpr double neither_noise_nor_detail = -1; // but a pattern

// The share n of white noise in the variance of the distances of vertices from the mean of their neighbors, told from
// the correlations along edges and of the two vertices opposite to an edge, across it. For white noise they are -0.17
// and 0.08. For surface detail they are 0.3 to 0.8 and, as those vertices are further apart, about that to the power of
// 1.4. So n solves across - 0.08 n = (1 - n) ((along + 0.17 n) / (1 - n))^1.4.
inline double noise_share(double along, double across)
{
  constexpr double noise_along = -0.17, noise_across = 0.08;
  constexpr double least_detail_along = 0.3, most_detail_along = 0.8, most_detail_across = 0.85;
  constexpr double tolerance = 0.3;
  constexpr int steps = 100;

  const auto share = [](double correlation, double of_noise, double of_detail) {
    return (of_detail - correlation) / (of_detail - of_noise);
  };
  const double least = share(along, noise_along, least_detail_along);
  const double most =
    (std::min)(share(along, noise_along, most_detail_along), share(across, noise_across, most_detail_across));
  if(least > most + tolerance)
    return neither_noise_nor_detail;
  for(int i = 0; i < steps; ++i)
  {
    const double n = double(i) / steps;
    const double detail = (std::max)(0., (along - noise_along * n) / (1 - n));
    if(n >= most || (n >= least && across - noise_across * n <= (1 - n) * std::pow(detail, 1.4)))
      return n;
  }
  return 1;
}

// How far face normals are from the mean of their neighbors', in the median.
struct Roughness
{
  double of_faces, of_border_faces;

  Roughness(const Indexed_triangles& mesh, const Face_geometry& faces, const Dual_graph& dual)
  {
    std::vector<Vec3> sum(faces.normals.size(), Vec3(0, 0, 0));
    std::vector<int> degree(faces.normals.size(), 0);
    dual.for_each_edge(mesh, [&](int f, int g, int, int) {
      sum[f] += faces.normals[g];
      sum[g] += faces.normals[f];
      ++degree[f];
      ++degree[g];
    });
    std::vector<double> all, at_border;
    for(std::size_t f = 0; f < sum.size(); ++f)
      if(degree[f] > 0 && faces.normals[f] != Vec3(0, 0, 0))
      {
        all.push_back((faces.normals[f] - sum[f] / degree[f]).norm());
        if(touches_border(mesh, mesh.triangles[f]))
          at_border.push_back(all.back());
      }
    of_faces = median(std::move(all));
    of_border_faces = median(std::move(at_border));
  }
};

// A corner of two triangles in one plane was not displaced. Nearly all vertices of refined facets are such.
inline bool is_faceted(const Indexed_triangles& mesh, const Face_geometry& faces, const Dual_graph& dual,
                       double roughness)
{
  std::vector<char> is_in_place(mesh.points.size(), 0);
  dual.for_each_edge(mesh, [&](int f, int g, int, int) {
    if((faces.normals[f] - faces.normals[g]).norm() <= 0.01 * roughness)
      for(int h : {f, g})
        for(int v : mesh.triangles[h])
          is_in_place[v] = 1;
  });
  std::size_t inside = 0, in_place = 0;
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    if(!mesh.is_on_border[v] && mesh.corners.size(v) > 0)
    {
      ++inside;
      in_place += is_in_place[v];
    }
  return 20 * in_place > 19 * inside;
}

// How far vertices are above the mean of their neighbors.
class Vertex_offsets
{
  std::vector<double> m_offsets;
  std::vector<double> m_noise_inside, m_noise_of_border; // absolute, made comparable

public:
  Vertex_offsets(const Indexed_triangles& mesh, const std::vector<Vec3>& normals, const Lists& rings)
    : m_offsets(mesh.points.size(), 0)
  {
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
    {
      if(rings.size(v) == 0)
        continue;
      Vec3 mean(0, 0, 0), border_mean(0, 0, 0);
      int border_neighbors = 0;
      for(const int* w = rings.begin(v); w != rings.end(v); ++w)
      {
        mean += mesh.points[*w] / rings.size(v);
        if(mesh.is_on_border[*w])
        {
          border_mean += mesh.points[*w] / 2;
          ++border_neighbors;
        }
      }
      m_offsets[v] = (mesh.points[v] - mean).dot(normals[v]);
      if(!mesh.is_on_border[v])
        m_noise_inside.push_back(std::abs(m_offsets[v]) / std::sqrt(1 + 1. / rings.size(v)));
      else if(border_neighbors == 2)
        m_noise_of_border.push_back(std::abs((mesh.points[v] - border_mean).dot(normals[v])) / std::sqrt(1.5));
    }
  }

  double share_of_noise(const Indexed_triangles& mesh, const Dual_graph& dual) const
  {
    Pair_correlation along, across;
    const auto insert = [&](Pair_correlation& correlation, int v, int w) {
      if(!mesh.is_on_border[v] && !mesh.is_on_border[w])
        correlation.insert(m_offsets[v], m_offsets[w]);
    };
    dual.for_each_edge(mesh, [&](int f, int g, int v, int w) {
      const auto& s = mesh.triangles[f];
      const auto& t = mesh.triangles[g];
      insert(along, v, w);
      insert(across, s[0] + s[1] + s[2] - v - w, t[0] + t[1] + t[2] - v - w);
    });
    const double by_medians = noise_share(along.of_medians(), across.of_medians());
    const double by_means = noise_share(along.of_means(), across.of_means());
    return (std::min)(by_medians, by_means) == neither_noise_nor_detail ? 0 : (std::max)(by_medians, by_means);
  }

  double border_variance() const
  {
    const double inside = median(m_noise_inside);
    return m_noise_of_border.empty() || inside == 0 ? 1 : std::pow(median(m_noise_of_border) / inside, 2);
  }
};

inline Noise_estimate estimate_noise(const Indexed_triangles& mesh, const Face_geometry& faces, const Dual_graph& dual,
                                     const Lists& rings, bool parallel)
{
  constexpr double normal_noise_by_roughness = 1.5;
  constexpr double level_of_clean_meshes = 0.07; // curvature and coarse triangulation look like so much noise
  // as exactly as a share is known
  const double share_of_clean_meshes = 0.08 + 1 / std::sqrt(1. + 1.5 * double(faces.normals.size()));

  const Roughness roughness(mesh, faces, dual);
  const Vertex_offsets offsets(mesh, vertex_normals(mesh, faces.areas, faces.normals, parallel), rings);
  const double share = offsets.share_of_noise(mesh, dual);

  Noise_estimate noise;
  noise.share = std::sqrt(share);
  noise.border_variance = offsets.border_variance();
  if(roughness.of_border_faces < roughness.of_faces)
    noise.border_level = roughness.of_border_faces / roughness.of_faces;
  noise.roughness_level = normal_noise_by_roughness * roughness.of_faces;
  const double level = noise.roughness_level * noise.share;
  if(share > share_of_clean_meshes && level > level_of_clean_meshes
     && !is_faceted(mesh, faces, dual, roughness.of_faces))
    noise.level = std::sqrt(level * level - level_of_clean_meshes * level_of_clean_meshes);
  return noise;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_NOISE_ESTIMATE_H
