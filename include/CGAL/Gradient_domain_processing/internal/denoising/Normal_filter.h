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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_NORMAL_FILTER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_NORMAL_FILTER_H

#include <CGAL/Gradient_domain_processing/internal/denoising/Dual_system.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Face_geometry.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/constants.h>

#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// How much the normals of a triangle are smoothed.
struct Normal_smoothing
{
  double similarity; // the difference of normals that counts as small
  double weight;     // a length
};

// g = normalize((A + beta L)^-1 A n), with weights l / (1 + |g_a - g_b|^2 / sigma^2)^2 (Geman and McClure) from the
// last g.
class Normal_filter
{
  const Indexed_triangles& m_mesh;
  const Dual_graph& m_dual;
  Dual_system<Vec3f> m_system;
  bool m_parallel;
  std::vector<Vec3f> m_right, m_solution;

public:
  Normal_filter(const Indexed_triangles& mesh, const Dual_graph& dual, bool parallel)
    : m_mesh(mesh)
    , m_dual(dual)
    , m_system(dual, parallel)
    , m_parallel(parallel)
    , m_right(dual.size())
    , m_solution(dual.size())
  {}

  // smoothing(f) says it for a triangle; an edge gets the mean of its two.
  template <class Smoothing>
  void operator()(const std::vector<Vec3>& points, const Face_geometry& faces, const Smoothing& smoothing,
                  std::vector<Vec3>& normals)
  {
    // noise makes triangles larger: the root halves what it adds
    const double mean_area = std::accumulate(faces.areas.begin(), faces.areas.end(), 0.) / double(faces.areas.size());
    m_system.masses.resize(faces.areas.size());
    parallel_for(m_parallel, m_right.size(), [&](std::size_t f) {
      m_system.masses[f] = float(std::sqrt(mean_area * faces.areas[f]));
      m_solution[f] = single(faces.normals[f]);
      m_right[f] = m_system.masses[f] * m_solution[f];
    });
    normals = faces.normals;
    for(int i = 0; i < denoising::normal_updates; ++i)
    {
      weigh(points, smoothing, normals);
      m_system.solve(m_right, denoising::normal_tolerance, denoising::most_solver_steps, m_solution);
      parallel_for(m_parallel, normals.size(), [&](std::size_t f) {
        const Vec3 normal = as_double(m_solution[f]);
        const double length = normal.norm();
        if(length > 0)
          normals[f] = normal / length;
      });
    }
  }

private:
  template <class Smoothing>
  void weigh(const std::vector<Vec3>& points, const Smoothing& smoothing, const std::vector<Vec3>& normals)
  {
    parallel_for(m_parallel, normals.size(), [&](std::size_t f) {
      const Normal_smoothing own = smoothing(int(f));
      for(int i = 0; i < 3; ++i)
      {
        const int g = m_dual.neighbor(int(f), i);
        m_system.weights[f][i] = 0;
        if(g < 0)
          continue;
        const Normal_smoothing other = smoothing(g);
        const double sigma = (own.similarity + other.similarity) / 2, beta = (own.weight + other.weight) / 2;
        const double q = 1 + (normals[f] - normals[g]).squaredNorm() / (sigma * sigma);
        const auto& t = m_mesh.triangles[f];
        m_system.weights[f][i] = float(beta * (points[t[i]] - points[t[(i + 1) % 3]]).norm() / (q * q));
      }
    });
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_NORMAL_FILTER_H
