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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_SMOOTH_BORDER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_SMOOTH_BORDER_H

#include <CGAL/Gradient_domain_processing/internal/denoising/Dual_graph.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/conjugate_gradients.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/constants.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Border vertices between two others follow the curve, those where borders meet stay: (w + L) x = w x_input with the
// Laplacian of the curve and edges of length one.
inline void smooth_border(const Indexed_triangles& mesh, const Dual_graph& dual,
                          const std::vector<char>& is_constrained, bool parallel, std::vector<Vec3>& points)
{
  const std::size_t n = points.size();
  std::vector<std::array<int, 2> > sides(n, {{-1, -1}});
  std::vector<int> degree(n, 0);
  for(int f = 0; f < mesh.number_of_triangles(); ++f)
    for(int i = 0; i < 3; ++i)
      if(dual.is_border(mesh, f, i))
        for(int j = 0; j < 2; ++j)
        {
          const int v = mesh.triangles[f][(i + j) % 3];
          if(degree[v] < 2)
            sides[v][degree[v]] = mesh.triangles[f][(i + 1 - j) % 3];
          ++degree[v];
        }
  const double weight = denoising::border_curve_weight;
  std::vector<double> inverse_diagonal(n, 0);
  std::vector<Vec3> right(n, Vec3(0, 0, 0)), change = right;
  const auto differences = [&](const std::vector<Vec3>& p, int v) {
    return Vec3(p[v] - p[sides[v][0]] + p[v] - p[sides[v][1]]);
  };
  for(int v = 0; v < int(n); ++v)
    if(degree[v] == 2 && !is_constrained[v])
    {
      right[v] = -differences(points, v);
      inverse_diagonal[v] = 1 / (weight + 2);
    }
  Conjugate_gradients<Vec3> solve(parallel);
  solve([&](const std::vector<Vec3>& p, int v) {
    return inverse_diagonal[v] == 0 ? Vec3(0, 0, 0) : Vec3(weight * p[v] + differences(p, v));
  }, inverse_diagonal, right, denoising::normal_tolerance, denoising::most_solver_steps, change);
  for(std::size_t v = 0; v < n; ++v)
    if(inverse_diagonal[v] != 0)
      points[v] += change[v];
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_SMOOTH_BORDER_H
