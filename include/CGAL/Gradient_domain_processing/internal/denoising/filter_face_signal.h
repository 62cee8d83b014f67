// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_FILTER_FACE_SIGNAL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_FILTER_FACE_SIGNAL_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Dual_system.h>
#include <CGAL/Gradient_domain_processing/visitor.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Equation 1 of the paper on the dual graph.
struct Face_energy
{
  std::vector<double> values;                    // alpha times the area of every triangle, positive
  std::vector<std::array<double, 3> > gradients; // beta times the weight of its edges, at least 0; what both triangles say is the same
  std::vector<double> scales;                    // lambda of every triangle; an edge gets the mean of its two
};

// (A + L) g = (A + lambda L) f for every column of `signal`, a row a triangle; solved for the change, so that nothing changes where
// lambda is 1.
inline Error_code filter_face_signal(const Dual_graph& dual, Face_energy energy, bool parallel, Progress& progress, Signal& signal)
{
  constexpr double tolerance = 1e-14;
  constexpr int most_steps = 100000;

  const std::size_t n = std::size_t(dual.size());
  Dual_system<double> system(dual, parallel);
  system.masses = std::move(energy.values);
  system.weights = std::move(energy.gradients);
  std::vector<double> right(n), change(n);
  for(Eigen::Index channel = 0; channel < signal.cols(); ++channel)
  {
    if(!progress.go_on(double(channel) / double(signal.cols())))
      return error_cancelled;
    parallel_for(parallel, n, [&](std::size_t f) {
      double flow = 0;
      for(int i = 0; i < 3; ++i)
      {
        const int g = dual.neighbor(int(f), i);
        if(g >= 0)
          flow += ((energy.scales[f] + energy.scales[g]) / 2 - 1) * system.weights[f][i] * (signal(f, channel) - signal(g, channel));
      }
      right[f] = flow;
      change[f] = 0;
    });
    if(!system.solve(right, tolerance, most_steps, change))
      return error_not_converged;
    for(std::size_t f = 0; f < n; ++f)
    {
      if(!std::isfinite(change[f]))
        return error_cannot_solve_linear_system;
      signal(f, channel) += change[f];
    }
  }
  return ok;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_FILTER_FACE_SIGNAL_H
