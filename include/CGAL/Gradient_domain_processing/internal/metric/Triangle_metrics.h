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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_METRIC_TRIANGLE_METRICS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_METRIC_TRIANGLE_METRICS_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/Untouched_vector.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The metric of every triangle. That of the embedding is computed when asked for: it costs no more than to be read, and
// no memory.
struct Triangle_metrics
{
  Untouched_vector<Triangle_metric> given; // none: the embedding

  Triangle_metric operator()(const Indexed_triangles& mesh, int f) const
  {
    return given.empty() ? mesh.embedding_metric(f).with_area_bounded_below(degeneracy_ratio) : given[f];
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_METRIC_TRIANGLE_METRICS_H
