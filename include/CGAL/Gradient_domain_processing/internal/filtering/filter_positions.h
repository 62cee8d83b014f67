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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_POSITIONS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_POSITIONS_H

#include <CGAL/Gradient_domain_processing/internal/filtering/move_positions.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/read_parameters.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The same factor applied several times to what is still missing, g_i = g_(i-1) + (alpha M + beta S)^-1 alpha M (f -
// g_(i-1)): a wave that one pass multiplies by s keeps 1 - (1 - s)^order, which is flat at long waves. What is missing
// after one is minus the change that smoothing makes of it.
Error_code smooth_without_shrinking(Filter& filter, int order);

// v = lambda grad f with the positions as signal; the metric follows the positions from pass to pass.
template <class Solver, class PointMap, class NamedParameters>
Error_code filter_positions(Solver solver, PointMap point_map, double default_scale, const NamedParameters& np)
{
  using namespace CGAL::internal_np;
  const int iterations = int(parameter(np, number_of_iterations, 1)),
            order = int(parameter(np, non_shrinking_order, 1));
  if(iterations < 0 || order < 1)
    return error_invalid_parameter;
  if(!Has_parameter<gradient_scale_t, NamedParameters>::value
     && !Has_parameter<face_gradient_scale_map_t, NamedParameters>::value)
    solver.arrays().system.set_scale(default_scale);

  return move_positions(solver, point_map, np, [&](const auto& end_of_pass) {
    for(int i = 0; i < iterations; ++i)
    {
      if(i > 0)
        if(const Error_code code = solver.set_metric_from_parameters(np))
          return code;
      if(const Error_code code =
           order == 1 ? solver.arrays().filter_points() : smooth_without_shrinking(solver.arrays(), order))
        return code;
      if(const Error_code code = end_of_pass())
        return code;
    }
    return ok;
  });
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/filtering/filter_positions_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_POSITIONS_H
