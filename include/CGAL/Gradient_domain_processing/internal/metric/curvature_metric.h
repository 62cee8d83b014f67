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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_METRIC_CURVATURE_METRIC_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_METRIC_CURVATURE_METRIC_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/enum.h>
#include <CGAL/Gradient_domain_processing/internal/curvature/Principal_curvatures.h>
#include <CGAL/Gradient_domain_processing/internal/metric/Triangle_metrics.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// (s1, s2) from the principal curvatures in units of the arrays.
typedef std::function<std::pair<double, double>(double, double)> Stretch;

// The stretches of the paper's metrics (2.3).
struct Curvature_stretch
{
  Curvature_metric_kind kind;
  double weight; // epsilon

  std::pair<double, double> operator()(double k1, double k2) const
  {
    switch(kind)
    {
      case Curvature_metric_kind::EDGE_AWARE: return {stretch(std::hypot(k1, k2)), stretch(std::hypot(k1, k2))};
      case Curvature_metric_kind::ANISOTROPIC: return {stretch(k1), stretch(k2)};
      case Curvature_metric_kind::PRESERVE_CONVEX: return {stretch((std::max)(0., k1)), stretch((std::max)(0., k2))};
      case Curvature_metric_kind::PRESERVE_CONCAVE: return {stretch((std::min)(0., k1)), stretch((std::min)(0., k2))};
      case Curvature_metric_kind::EMBEDDING: break;
    }
    return {1., 1.};
  }

private:
  // bounded, so that the curvatures of a degenerate triangle do not make the tensor one as well
  double stretch(double k) const { return (std::min)(1 + weight * k * k, 1e12); }
};

// The metric of every triangle. Names the first triangle whose stretch is none, or answers -1.
int stretched_metrics(const Indexed_triangles& mesh, const std::vector<Principal_curvatures>& curvatures,
                      const Stretch& stretch, bool parallel, Untouched_vector<Triangle_metric>& metrics);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/metric/curvature_metric_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_METRIC_CURVATURE_METRIC_H
