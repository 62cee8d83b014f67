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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FACE_ENERGY_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FACE_ENERGY_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/filtering/face_energy.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/conjugate_gradients.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE Error_code filter_face_signal(const Face_energy& energy, bool parallel, Progress& progress,
                                              Signal& signal)
{
  constexpr double tolerance = 1e-14;
  constexpr int most_steps = 100000;

  const std::size_t n = std::size_t(energy.size());
  Conjugate_gradients<double> solver(parallel);
  std::vector<double> right(n), change(n);
  for(Eigen::Index channel = 0; channel < signal.cols(); ++channel)
  {
    if(!progress.go_on(double(channel) / double(signal.cols())))
      return error_cancelled;
    parallel_for(parallel, n, [&](std::size_t f) {
      right[f] = change[f] = 0;
      energy.for_each_neighbor(int(f), [&](const Face_energy::Neighbor& g) {
        right[f] += ((energy.scales[f] + energy.scales[g.face]) / 2 - 1) * g.weight
                    * (signal(f, channel) - signal(g.face, channel));
      });
    });
    const auto row = [&](const std::vector<double>& p, int f) {
      double product = energy.values[f] * p[f];
      energy.for_each_neighbor(f, [&](const Face_energy::Neighbor& g) { product += g.weight * (p[f] - p[g.face]); });
      return product;
    };
    if(!solver(row, energy.inverse_diagonal, right, tolerance, most_steps, change))
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

CGAL_GDP_INLINE std::vector<Vec3> face_centers(const Indexed_triangles& mesh, std::size_t number_of_faces)
{
  std::vector<Vec3> centers(number_of_faces, Vec3::Zero());
  std::vector<double> areas(number_of_faces, 0.);
  for(int f = 0; f < mesh.number_of_triangles(); ++f)
  {
    const auto& t = mesh.triangles[f];
    const Vec3 center = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3;
    if(mesh.face_of_triangle.empty())
    {
      centers[f] = center;
      continue;
    }
    const Triangle_metric metric = mesh.embedding_metric(f).with_area_bounded_below(degeneracy_ratio);
    const double area = metric.area() > 0 ? metric.area() : (std::numeric_limits<double>::min)();
    centers[mesh.face_of(f)] += area * center;
    areas[mesh.face_of(f)] += area;
  }
  for(std::size_t f = 0; f < number_of_faces && !mesh.face_of_triangle.empty(); ++f)
    centers[f] /= areas[f];
  return centers;
}

CGAL_GDP_INLINE double default_edge_weight(const Vec3& v, const Vec3& w, const Vec3& center, const Vec3& other_center)
{
  const double length = (v - w).norm();
  return length / (std::max)((center - other_center).norm(), degeneracy_ratio * (length > 0 ? length : 1.));
}

CGAL_GDP_INLINE std::array<int, 2> edge_of_lower(const Indexed_triangles& mesh, int f, int i, int g)
{
  if(f < g)
    return {{mesh.rows_of(f)[i], mesh.rows_of(f)[(i + 1) % 3]}};
  const int v = mesh.triangles[f][i], w = mesh.triangles[f][(i + 1) % 3];
  for(int j = 0; j < 3; ++j)
  {
    const int a = mesh.triangles[g][j], b = mesh.triangles[g][(j + 1) % 3];
    if((a == v && b == w) || (a == w && b == v))
      return {{mesh.rows_of(g)[j], mesh.rows_of(g)[(j + 1) % 3]}};
  }
  return {{mesh.rows_of(f)[i], mesh.rows_of(f)[(i + 1) % 3]}};
}

CGAL_GDP_INLINE void count_neighbors(const Indexed_triangles& mesh, const Dual_graph& dual, Face_energy& energy)
{
  energy.first_neighbor.assign(energy.values.size() + 1, 0);
  for(int f = 0; f < dual.size(); ++f)
    for(int g : dual.neighbors(f))
      energy.first_neighbor[mesh.face_of(f) + 1] += g >= 0 && mesh.face_of(g) != mesh.face_of(f);
  for(std::size_t f = 0; f < energy.values.size(); ++f)
    energy.first_neighbor[f + 1] += energy.first_neighbor[f];
  energy.neighbors.resize(energy.first_neighbor.back());
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FACE_ENERGY_IMPL_H
