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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_DENOISE_POSITIONS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_DENOISE_POSITIONS_H

#include <CGAL/Gradient_domain_processing/Denoising_summary.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/denoise_points.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/move_positions.h>

#include <functional>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

template <class NamedParameters>
Denoising_options denoising_options(const NamedParameters& np)
{
  namespace tag = CGAL::internal_np;
  Denoising_options options;
  if constexpr (Has_parameter<tag::number_of_iterations_t, NamedParameters>::value)
    options.number_of_iterations = int(parameter(np, tag::number_of_iterations, 0));
  if constexpr (Has_parameter<tag::noise_level_t, NamedParameters>::value)
    options.noise_level = parameter(np, tag::noise_level, 0.);
  if constexpr (Has_parameter<tag::noise_scale_t, NamedParameters>::value)
    options.noise_scale = parameter(np, tag::noise_scale, 0.);
  if constexpr (Has_parameter<tag::value_weight_t, NamedParameters>::value)
    options.value_weight = parameter(np, tag::value_weight, 0.);
  options.border_is_smoothed_as_curve
    = parameter(np, tag::border_condition, Border_condition::FREE) == Border_condition::ALONG_BORDER;
  return options;
}

template <class Solver, class PointMap, class NamedParameters>
Error_code denoise_positions(Solver solver, PointMap point_map, const NamedParameters& np)
{
  if(solver.error() != ok)
    return solver.error();
  Denoising_summary summary;
  auto& filter = solver.arrays();
  if(filter.line_condition == Border_condition::ALONG_BORDER)
    return error_invalid_parameter; // lines are no curves of their own here
  const Error_code code = move_positions(solver, point_map, np, [&](const auto& end_of_pass) {
    const Denoising_options options = denoising_options(np);
    const Error_code result = denoise_points(filter.mesh(), filter.is_held, options, filter.system.parallel,
                                             solver.progress(), filter.system.mesh.points, summary);
    return result == ok ? end_of_pass() : result;
  }, filter.encloses_volume());
  if constexpr (Has_parameter<CGAL::internal_np::denoising_summary_t, NamedParameters>::value)
    if(code == ok)
      parameter(np, CGAL::internal_np::denoising_summary, std::ref(summary)).get() = summary;
  return code;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_DENOISE_POSITIONS_H
