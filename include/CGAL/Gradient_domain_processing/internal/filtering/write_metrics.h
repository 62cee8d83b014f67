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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_WRITE_METRICS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_WRITE_METRICS_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/Triangle_metric.h>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// In the unit of the surface; nothing is written if a tensor does not fit in numbers.
template <class Solver, class FaceMetricMap>
Error_code write_metrics(Solver solver, FaceMetricMap metrics)
{
  if(solver.error() != ok)
    return solver.error();
  auto& filter = solver.arrays();
  if(filter.mesh().virtual_vertices.size() > 0)
    return error_non_triangular_mesh;
  const double squared_unit = filter.mesh().unit() * filter.mesh().unit();
  std::vector<Triangle_metric> result;
  for(int f = 0; f < filter.mesh().number_of_triangles(); ++f)
  {
    result.push_back(filter.system.metric(f).scaled(squared_unit));
    if(filter.system.metric(f).is_valid() && !result.back().is_valid())
    {
      filter.culprit.face = f;
      return solver.checked(error_result_out_of_range);
    }
  }
  for(std::size_t f = 0; f < result.size(); ++f)
    put(metrics, solver.elements().faces[f], result[f]);
  return ok;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_WRITE_METRICS_H
