// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_METRIC_CURVATURE_METRIC_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_METRIC_CURVATURE_METRIC_H

#include <CGAL/Gradient_domain_processing/enum.h>
#include <CGAL/Gradient_domain_processing/internal/energy/Linear_system.h>
#include <CGAL/Gradient_domain_processing/internal/curvature/face_curvature.h>
#include <CGAL/Gradient_domain_processing/internal/curvature/jet_curvature.h>
#include <CGAL/Gradient_domain_processing/internal/curvature/normal_curvature.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The stretches of the paper's metrics.
struct Curvature_stretch
{
  Curvature_metric_kind kind;
  double weight; // epsilon

  std::pair<double, double> operator()(double k1, double k2) const
  {
    switch(kind)
    {
      case Curvature_metric_kind::EDGE_AWARE: return {stretch(std::hypot(k1, k2)), stretch(std::hypot(k1, k2))};
      case Curvature_metric_kind::ANISOTROPIC: return {stretch(k1), stretch(k2)};
      case Curvature_metric_kind::PRESERVE_CONVEX: return {stretch((std::max)(0., k1)), stretch((std::max)(0., k2))};
      case Curvature_metric_kind::PRESERVE_CONCAVE: return {stretch((std::min)(0., k1)), stretch((std::min)(0., k2))};
      case Curvature_metric_kind::EMBEDDING: break;
    }
    return {1., 1.};
  }

private:
  // bounded, so that the curvatures of a degenerate triangle do not make the tensor one as well
  double stretch(double k) const { return (std::min)(1 + weight * k * k, 1e12); }
};

inline bool is_valid_stretch(const std::pair<double, double>& s)
{
  return s.first > 0 && s.second > 0 && std::isfinite(s.first) && std::isfinite(s.second);
}

// The metric of every triangle, stretched as `stretch(k1, k2)` says. Where the principal curvatures are equal, the directions
// mean nothing and the metric is a multiple of the embedding's.
template <class Stretch>
Error_code stretched_metrics(const Indexed_triangles& mesh, const std::vector<Principal_curvatures>& curvatures,
                             const Stretch& stretch, bool parallel, Untouched_vector<Triangle_metric>& metrics)
{
  metrics.resize(mesh.number_of_triangles());
  std::atomic<bool> is_valid(true);
  parallel_for(parallel, metrics.size(), [&](std::size_t f) {
    const Principal_curvatures& k = curvatures[f];
    const std::pair<double, double> s = stretch(k.min_curvature, k.max_curvature);
    const double s1 = s.first, s2 = s.second;
    if(!is_valid_stretch(s))
    {
      is_valid = false;
      return;
    }
    const auto& t = mesh.triangles[f];
    const double size = (std::max)(std::abs(k.min_curvature), std::abs(k.max_curvature));
    const bool is_umbilic = k.max_curvature - k.min_curvature <= 1e-12 * size;
    const Triangle_metric embedding = mesh.embedding_metric(int(f));
    const bool is_degenerate = embedding.sqrt_determinant() <= degeneracy_ratio * embedding.max_squared_length();
    metrics[f] = (s1 == s2 || is_umbilic || is_degenerate)
               ? embedding.scaled(s1 == s2 ? s1 : std::sqrt(s1 * s2))
               : Triangle_metric::stretched(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]],
                                            s1, k.min_direction, s2, k.max_direction);
    metrics[f] = metrics[f].with_area_bounded_below(degeneracy_ratio);
  });
  return is_valid ? OK : ERROR_INVALID_METRIC;
}

struct Curvature_options
{
  Curvature_estimator estimator = Curvature_estimator::JETS;
  int jet_degree = 2;
  double presmoothing_weight = 0; // in units of the arrays
};

inline Signal as_signal(const std::vector<Vec3>& vectors)
{
  return Eigen::Map<const Signal>(vectors.empty() ? nullptr : vectors[0].data(), Eigen::Index(vectors.size()), 3);
}

// The channels of a signal smoothed with the metric of the embedding: copies for estimating curvatures.
template <class System>
Error_code presmooth(System& system, double weight, Progress& progress, Signal& signal)
{
  if(weight == 0)
    return OK;
  Weights weights;
  weights.gradient = weight;
  system.set_embedding_metric();
  system.set_weights(weights);
  Signal change;
  if(const Error_code code = system.solve(system.excess_of_filter(signal), int(signal.cols()), progress, change))
    return code;
  signal += change;
  return OK;
}

// Leaves the system with other metrics and weights than it had.
template <class System>
Error_code vertex_curvatures_by_jets(System& system, const std::vector<Vec3>* given_normals, const Curvature_options& options,
                                     Progress& progress, std::vector<Principal_curvatures>& curvatures)
{
  const Indexed_triangles& mesh = system.mesh;
  Signal positions = as_signal(mesh.points);
  if(const Error_code code = presmooth(system, options.presmoothing_weight, progress, positions))
    return code;

  if(!progress.go_on(0))
    return ERROR_CANCELLED;
  Stage_scope stage(progress, Stage::CURVATURE);
  Indexed_triangles smoothed;
  smoothed.triangles = mesh.triangles;
  smoothed.corners = mesh.corners;
  smoothed.points.resize(mesh.points.size());
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    smoothed.points[v] = positions.row(v).transpose();

  const std::vector<Vec3> normals = given_normals ? *given_normals : smoothed.vertex_normals(system.parallel);
  const Lists rings = smoothed.one_rings(system.parallel);
  const bool done = jet_curvatures(system.parallel, smoothed.points, rings.offsets, rings.items, normals, options.jet_degree,
                                   [&](double part) { return progress.go_on(part); }, curvatures);
  return done ? OK : ERROR_CANCELLED;
}

inline std::vector<Principal_curvatures> face_curvatures(const Indexed_triangles& mesh,
                                                         const std::vector<Principal_curvatures>& at_vertices, bool parallel)
{
  std::vector<Principal_curvatures> curvatures(mesh.number_of_triangles());
  parallel_for(parallel, curvatures.size(), [&](std::size_t f) {
    const auto& t = mesh.triangles[f];
    curvatures[f] = triangle_curvatures(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]],
                                        at_vertices[t[0]], at_vertices[t[1]], at_vertices[t[2]]);
  });
  return curvatures;
}

// Leaves the system with other metrics and weights than it had.
template <class System>
Error_code face_curvatures_by_normals(System& system, const std::vector<Vec3>* given_normals, const Curvature_options& options,
                                      Progress& progress, std::vector<Principal_curvatures>& curvatures)
{
  const Indexed_triangles& mesh = system.mesh;
  Signal smoothed = as_signal(given_normals ? *given_normals : mesh.vertex_normals(system.parallel));
  if(const Error_code code = presmooth(system, options.presmoothing_weight, progress, smoothed))
    return code;

  if(!progress.go_on(0))
    return ERROR_CANCELLED;
  Stage_scope stage(progress, Stage::CURVATURE);
  std::vector<Vec3> normals(mesh.points.size());
  parallel_for(system.parallel, normals.size(), [&](std::size_t v) {
    const Vec3 n = smoothed.row(v).transpose();
    const double length = n.norm();
    normals[v] = length > 0 ? Vec3(n / length) : n;
  });
  curvatures.resize(mesh.number_of_triangles());
  parallel_for(system.parallel, curvatures.size(), [&](std::size_t f) {
    const auto& t = mesh.triangles[f];
    curvatures[f] = triangle_curvatures(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]],
                                        normals[t[0]], normals[t[1]], normals[t[2]]);
  });
  return OK;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_METRIC_CURVATURE_METRIC_H
