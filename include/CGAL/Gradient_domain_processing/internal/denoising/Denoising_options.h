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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_DENOISING_OPTIONS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_DENOISING_OPTIONS_H

#include <cmath>
#include <optional>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// What is not named is found from the data.
struct Denoising_options
{
  std::optional<int> number_of_iterations;
  std::optional<double> noise_level, noise_scale, value_weight;
  bool border_is_smoothed_as_curve = false;

  bool are_valid() const
  {
    const auto is_at_least = [](const std::optional<double>& x, double least) {
      return !x || (*x >= least && std::isfinite(*x));
    };
    return (!number_of_iterations || *number_of_iterations >= 0) && is_at_least(noise_level, 0)
           && is_at_least(noise_scale, 0) && is_at_least(value_weight, 0) && (!value_weight || *value_weight > 0);
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_DENOISING_OPTIONS_H
