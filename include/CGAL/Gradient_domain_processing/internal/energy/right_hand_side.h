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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_RIGHT_HAND_SIDE_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_RIGHT_HAND_SIDE_H

#include <CGAL/Gradient_domain_processing/internal/energy/assemble.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The channels of a target field along an edge: three of them, which the compiler unrolls, or any number.
struct Three_channels
{
  double values[3];
  explicit Three_channels(int) {}
  static constexpr int size() { return 3; }
  double& operator[](int i) { return values[i]; }
};
struct Any_channels
{
  std::vector<double> values;
  explicit Any_channels(int n) : values(n) {}
  int size() const { return int(values.size()); }
  double& operator[](int i) { return values[i]; }
};

// beta (D v - S f) (eq. 2): what the target field v asks for beyond the gradients of f. A target field has a number of
// channels and target.residual(f, i, j, along), which sets the integral of v - grad f from corner i to corner j of
// triangle f.
template <class Channels, class Target_field>
void add_target_residual(const Indexed_triangles& mesh, const Triangle_metrics& metrics, const Energy_weights& weights,
                         const Degrees_of_freedom& dofs, const Target_field& target, bool parallel,
                         Eigen::MatrixXd& residual)
{
  for_each_degree_of_freedom(
    parallel, dofs, mesh, metrics, [&](int v, int row, const Block_coefficients& coefficients) {
      Channels sum(target.channels()), along_a(target.channels()), along_b(target.channels());
      for(int channel = 0; channel < sum.size(); ++channel)
        sum[channel] = 0;
      for(const int* c = mesh.corners.begin(v); c != mesh.corners.end(v); ++c)
      {
        const int f = *c / 3, i = *c % 3, j = (i + 1) % 3, k = (i + 2) % 3;
        const double beta = weights.gradient_at(f);
        const Triangle_coefficients of_f = coefficients(f);
        const double to_a = beta * of_f.half_cotangents[k], to_b = beta * of_f.half_cotangents[j];
        target.residual(f, i, j, along_a);
        target.residual(f, i, k, along_b);
        for(int channel = 0; channel < sum.size(); ++channel)
          sum[channel] -= to_a * along_a[channel] + to_b * along_b[channel];
      }
      for(int channel = 0; channel < sum.size(); ++channel)
        residual(row, channel) = sum[channel];
    });
}

template <class Target_field>
Eigen::MatrixXd target_residual(const Indexed_triangles& mesh, const Triangle_metrics& metrics,
                                const Energy_weights& weights, const Degrees_of_freedom& dofs,
                                const Target_field& target, bool parallel)
{
  Eigen::MatrixXd residual(dofs.size(), target.channels());
  if(target.channels() == 3)
    add_target_residual<Three_channels>(mesh, metrics, weights, dofs, target, parallel, residual);
  else
    add_target_residual<Any_channels>(mesh, metrics, weights, dofs, target, parallel, residual);
  return residual;
}

// Takes from the residual what the displacements of vertices that are not solved for bring about.
void move_to_right_hand_side(const Indexed_triangles& mesh, const Triangle_metrics& metrics,
                             const Energy_weights& weights, const Degrees_of_freedom& dofs, const Signal& displacement,
                             bool parallel, Eigen::MatrixXd& residual);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/energy/right_hand_side_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_RIGHT_HAND_SIDE_H
