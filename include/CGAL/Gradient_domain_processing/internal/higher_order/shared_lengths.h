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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_SHARED_LENGTHS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_SHARED_LENGTHS_H

#include <CGAL/Gradient_domain_processing/Triangle_metric.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>
#include <CGAL/Gradient_domain_processing/internal/metric/Triangle_metrics.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_for.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The squared length of the edge opposite to a corner.
inline double squared_length(const Triangle_metric& metric, int corner)
{
  return metric.corner_product((corner + 1) % 3) + metric.corner_product((corner + 2) % 3);
}

// Goes from the squared lengths of a metric towards others, as far as half of the area remains. Metrics with at least
// so much area are a convex set: it is a way to the end, or to the first root of a quadratic.
inline Triangle_metric towards(const Triangle_metric& metric, const std::array<double, 3>& lengths)
{
  const double g11 = metric.g11(), g12 = metric.g12(), g22 = metric.g22();
  const double to_11 = lengths[2] - g11, to_22 = lengths[1] - g22,
               to_12 = (lengths[1] + lengths[2] - lengths[0]) / 2 - g12;
  const double half_area = metric.sqrt_determinant() / 2;
  const double c = metric.sqrt_determinant() * metric.sqrt_determinant() - half_area * half_area;
  const double b = g11 * to_22 + g22 * to_11 - 2 * g12 * to_12, a = to_11 * to_22 - to_12 * to_12;
  double step = 1;
  if(a + b + c < 0)
    step = 2 * c / (std::sqrt(b * b - 4 * a * c) - b);
  return Triangle_metric(g11 + step * to_11, g12 + step * to_12, g22 + step * to_22);
}

// Under a metric that differs from triangle to triangle, an edge has two lengths. A covariant derivative needs one: the
// angles between the edges of a triangle say how vectors are carried over it, to second order only if its lengths are
// those at the edges. Each triangle takes the mean of the squared lengths, unless that makes a triangle of less than
// half its area, as where a crease stretches its neighbor; it then goes as far as that. A metric that is the same on
// both sides stays to the bit.
inline std::vector<Triangle_metric> with_shared_lengths(const Indexed_triangles& mesh, const Triangle_metrics& metrics,
                                                        const std::vector<int>& neighbors, bool parallel)
{
  std::vector<Triangle_metric> shared(mesh.triangles.size());
  parallel_for(parallel, shared.size(), [&](std::size_t f) {
    shared[f] = metrics(mesh, int(f));
    std::array<double, 3> lengths;
    bool differs = false;
    for(int i = 0; i < 3; ++i)
    {
      const double own = squared_length(shared[f], i);
      const int across = neighbors[3 * f + std::size_t(i)];
      const double other = across < 0 ? own : squared_length(metrics(mesh, across / 3), across % 3);
      lengths[std::size_t(i)] = (own + other) / 2;
      differs = differs || std::abs(own - other) > 1e-12 * own;
    }
    if(differs && shared[f].sqrt_determinant() > 0)
      shared[f] = towards(shared[f], lengths).with_area_bounded_below(degeneracy_ratio);
  });
  return shared;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_SHARED_LENGTHS_H
