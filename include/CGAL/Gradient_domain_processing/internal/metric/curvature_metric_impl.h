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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_METRIC_CURVATURE_METRIC_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_METRIC_CURVATURE_METRIC_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/metric/curvature_metric.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE bool is_valid_stretch(const std::pair<double, double>& s)
{
  return s.first > 0 && s.second > 0 && std::isfinite(s.first) && std::isfinite(s.second);
}

// The metric of a triangle, stretched. Where the principal curvatures are equal, the directions mean nothing and the
// metric is a multiple of the embedding's.
CGAL_GDP_INLINE Triangle_metric stretched_metric(const Indexed_triangles& mesh, int f, const Principal_curvatures& k,
                                        const std::pair<double, double>& s)
{
  const auto& t = mesh.triangles[f];
  const double size = (std::max)(std::abs(k.min_curvature), std::abs(k.max_curvature));
  const bool is_umbilic = k.max_curvature - k.min_curvature <= 1e-12 * size;
  const Triangle_metric embedding = mesh.embedding_metric(f);
  const bool is_degenerate = embedding.sqrt_determinant() <= degeneracy_ratio * embedding.max_squared_length();
  const Triangle_metric metric = (s.first == s.second || is_umbilic || is_degenerate)
    ? embedding.scaled(s.first == s.second ? s.first : std::sqrt(s.first * s.second))
    : Triangle_metric::stretched(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]],
                                 s.first, k.min_direction, s.second, k.max_direction);
  return metric.with_area_bounded_below(degeneracy_ratio);
}

CGAL_GDP_INLINE int stretched_metrics(const Indexed_triangles& mesh,
                                      const std::vector<Principal_curvatures>& curvatures, const Stretch& stretch,
                                      bool parallel, Untouched_vector<Triangle_metric>& metrics)
{
  constexpr std::size_t block_size = 2048;
  metrics.resize(mesh.triangles.size());
  std::vector<int> first_bad((metrics.size() + block_size - 1) / block_size, -1);
  for_each_block(parallel, metrics.size(), block_size, [&](std::size_t begin, std::size_t end) {
    for(std::size_t f = begin; f < end; ++f)
    {
      const std::pair<double, double> s = stretch(curvatures[f].min_curvature, curvatures[f].max_curvature);
      if(is_valid_stretch(s))
        metrics[f] = stretched_metric(mesh, int(f), curvatures[f], s);
      else if(first_bad[begin / block_size] < 0)
        first_bad[begin / block_size] = int(f);
    }
  });
  for(int f : first_bad)
    if(f >= 0)
      return f;
  return -1;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_METRIC_CURVATURE_METRIC_IMPL_H
