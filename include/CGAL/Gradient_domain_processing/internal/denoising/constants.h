// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_CONSTANTS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_CONSTANTS_H

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {
namespace denoising {

constexpr int most_passes = 20;
constexpr int border_passes = 5;
constexpr int normal_updates = 2;
constexpr int position_updates = 3;
#ifndef TUNE
#define TUNE constexpr
#endif
TUNE double value_weight = 0.05;
TUNE double similarity = 2.8, similarity_decay = 0.84, similarity_min = 0.2, similarity_max = 1;
TUNE double smoothing = 0.6, smoothing_growth = 1.05, smoothing_max = 3;
TUNE double residual_correlation = 0.07;
TUNE double border_value_weight = 3, border_normal_decay = 0.85;
TUNE double normal_tolerance = 1e-3, position_tolerance = 1e-2;
TUNE double weak_outlier = 0.25, strong_outlier = 1.2, outlier_by_median = 6, outlier_by_ring = 2.5, least_weak_share = 0.01;
TUNE double fine_smoothing = 4, least_rough_angle = 0.12, least_correlated_excess = 0.06, correlated_level = 0.15, correlated_scale = 6, rest_scale = 1.5;
constexpr int correlation_sample = 3000;
constexpr int least_component = 200;
constexpr int outlier_steps = 10;
constexpr int outlier_rounds = 3;
constexpr int most_solver_steps = 200;

} // namespace denoising
} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_CONSTANTS_H
