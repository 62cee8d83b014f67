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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/filtering/Filter.h>
#include <CGAL/Gradient_domain_processing/internal/curvature/estimates.h>
#include <CGAL/Gradient_domain_processing/internal/energy/Linear_system_impl.h>
#include <CGAL/Gradient_domain_processing/internal/energy/border_energy.h>
#include <CGAL/Gradient_domain_processing/internal/energy/border_energy_impl.h>
#include <CGAL/Gradient_domain_processing/internal/energy/target_field/Scaled_gradient.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/At_end.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/hessian_energy.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/is_oriented.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/energy/target_field/Given_gradient.h>
#include <CGAL/Gradient_domain_processing/internal/energy/target_field/Normal_fit.h>
#include <CGAL/Gradient_domain_processing/internal/energy/target_field/Seam.h>
#endif

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// v = lambda grad f for a signal by vertex.
struct Filter::Scaled_difference_of_vertices
{
  const Indexed_triangles& mesh;
  const Energy_weights& weights;
  const Signal& signal;

  int channels() const { return int(signal.cols()); }
  const Signal& by_vertex() const { return signal; }

  template <class Channels>
  void residual(int f, int i, int j, Channels& along) const
  {
    const auto& t = mesh.triangles[f];
    for(int channel = 0; channel < along.size(); ++channel)
      along[channel] = (weights.scale_at(f) - 1) * (signal(t[j], channel) - signal(t[i], channel));
  }
};

CGAL_GDP_INLINE void Filter::constrain(std::vector<char> constrained)
{
  is_constrained = is_held = constrained;
  if(border_condition != Border_condition::FREE)
    hold(border_condition, mesh().is_on_border, constrained);
  if(line_condition != Border_condition::FREE)
    hold(line_condition, vertices_at(line_edges(mesh()), mesh()), constrained);
  system.set_constrained(std::move(constrained));
}

CGAL_GDP_INLINE void Filter::hold(Border_condition condition, const std::vector<char>& is_on_curve,
                                  std::vector<char>& constrained)
{
  for(std::size_t v = 0; v < constrained.size(); ++v)
    if(is_on_curve[v])
    {
      constrained[v] = 1;
      is_held[v] = is_held[v] || condition == Border_condition::FIXED;
    }
}

// As many vertices as there are functions on a plane that cost nothing; linear ones, and for the trace-free energy
// x^2 + y^2.
CGAL_GDP_INLINE int needed_constraints(Hessian_kind kind)
{
  switch(kind)
  {
    case Hessian_kind::BILAPLACIAN: return 1;
    case Hessian_kind::TRACE_FREE_HESSIAN: return 4;
    default: return 3;
  }
}

CGAL_GDP_INLINE void Filter::set_second_order(double weight, Hessian_kind kind)
{
  if(weight == 0)
    system.set_second_order({});
  else
    system.set_second_order(
      [weight, kind](const Indexed_triangles& triangles, const Triangle_metrics& metrics, bool parallel) {
        return Sparse_matrix(weight * hessian_energy(triangles, metrics, kind, parallel));
      },
      needed_constraints(kind));
}

CGAL_GDP_INLINE bool Filter::encloses_volume() const
{
  for(int v = 0; v < mesh().number_of_vertices(); ++v)
    if(mesh().is_on_border[v])
      return false;
  return std::find(is_held.begin(), is_held.end(), 1) == is_held.end() && is_oriented(mesh());
}

CGAL_GDP_INLINE Error_code Filter::set_curvature_metric(const std::vector<Principal_curvatures>& curvatures,
                                                        const Stretch& stretch)
{
  if(const Error_code code = ready())
    return code;
  Stage_scope stage(*m_progress, Stage::METRIC);
  Untouched_vector<Triangle_metric> metrics;
  const int bad = stretched_metrics(mesh(), curvatures, stretch, system.parallel, metrics);
  if(bad >= 0)
  {
    culprit.face = mesh().face_of(bad);
    return error_invalid_metric;
  }
  system.set_metrics(std::move(metrics));
  return ok;
}

template <class Void>
Error_code Filter::estimate_by_jets(const Curvature_options& options, std::vector<Principal_curvatures>& curvatures)
{
  Signal positions = as_signal(mesh().points);
  if(const Error_code code = presmooth(options.presmoothing_weight, positions))
    return code;
  if(const Error_code code = ready())
    return code;
  Stage_scope stage(*m_progress, Stage::CURVATURE);
  const std::vector<Vec3> points = as_vectors(positions);
  const bool is_done = vertex_curvatures_by_jets(
    mesh(), points, options.normals.empty() ? mesh().vertex_normals(points, system.parallel) : options.normals,
    options.jet_degree, system.parallel, [this](double part) { return this->m_progress->go_on(part); }, curvatures);
  return is_done ? ok : error_cancelled;
}

template <class Void>
Error_code Filter::estimate(const Curvature_options& options, std::vector<Principal_curvatures>& curvatures)
{
  if(options.estimator == Curvature_estimator::JETS)
  {
    std::vector<Principal_curvatures> at_vertices;
    if(const Error_code code = estimate_by_jets(options, at_vertices))
      return code;
    curvatures = triangle_curvatures(mesh(), system.parallel, at_vertices);
    return ok;
  }
  Signal normals = as_signal(options.normals.empty() ? mesh().vertex_normals(system.parallel) : options.normals);
  if(const Error_code code = presmooth(options.presmoothing_weight, normals))
    return code;
  if(const Error_code code = ready())
    return code;
  Stage_scope stage(*m_progress, Stage::CURVATURE);
  curvatures = triangle_curvatures_by_normals(mesh(), system.parallel, as_vectors(normals));
  return ok;
}

template <class Target_field>
Error_code Filter::solve(const Target_field& target, Signal& change)
{
  std::vector<Border_edge> edges;
  if(border_condition == Border_condition::ALONG_BORDER)
    edges = border_edges(mesh());
  if(line_condition == Border_condition::ALONG_BORDER)
    for(const Border_edge& e : line_edges(mesh()))
      edges.push_back(e);
  if(edges.empty())
    return system.solve(target, *m_progress, change);
  change.setZero(mesh().number_of_vertices(), target.channels());
  if(const Error_code code = displace_curves(mesh(), std::move(edges), system.weights(), is_held, target, change))
    return code;
  return system.solve(target, *m_progress, change, true);
}

CGAL_GDP_INLINE void Filter::add(const Signal& change, Signal& signal) const
{
  if(mesh().vertex_of_row.empty())
    signal += change;
  else
    for(int row = 0; row < mesh().number_of_rows(); ++row)
      signal.row(row) += change.row(mesh().vertex_of(row));
}

template <class Void>
Error_code Filter::filter(Signal& signal)
{
  Signal change;
  if(const Error_code code = solve(Scaled_gradient(mesh(), system.weights(), signal), change))
    return code;
  add(change, signal);
  return ok;
}

CGAL_GDP_INLINE Error_code Filter::filter_points()
{
  Signal change;
  if(const Error_code code = solve(Scaled_gradient_of_positions(mesh(), system.weights()), change))
    return code;
  move_points(change);
  return ok;
}

CGAL_GDP_INLINE Error_code Filter::solve_by_vertex(const Signal& signal, Signal& change)
{
  return solve(Scaled_difference_of_vertices{mesh(), system.weights(), signal}, change);
}

CGAL_GDP_INLINE void Filter::move_points(const Signal& change)
{
  std::vector<Vec3>& points = system.mesh.points;
  for(std::size_t v = 0; v < points.size(); ++v)
    points[v] += change.row(Eigen::Index(v)).transpose();
}

template <class Void>
Error_code Filter::presmooth(double weight, Signal& signal)
{
  if(weight == 0)
    return ok;
  Linear_system::Coefficients other;
  other.weights.gradient = weight;
  Linear_system::Coefficients own = system.exchange_coefficients(std::move(other));
  const At_end scope([&] { system.exchange_coefficients(std::move(own)); });
  Signal change;
  if(const Error_code code =
       system.solve(Scaled_difference_of_vertices{mesh(), system.weights(), signal}, *m_progress, change))
    return code;
  signal += change;
  return ok;
}

#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
template Error_code Filter::estimate_by_jets<>(const Curvature_options& options,
                                               std::vector<Principal_curvatures>& curvatures);
template Error_code Filter::estimate<>(const Curvature_options& options, std::vector<Principal_curvatures>& curvatures);
template Error_code Filter::filter<>(Signal& signal);
template Error_code Linear_system::solve(const Scaled_gradient&, Progress&, Signal&, bool);
template Error_code Filter::solve(const Scaled_gradient&, Signal&);
template Error_code Filter::solve(const Given_gradient&, Signal&);
template Error_code Filter::solve(const Normal_fit&, Signal&);
template Error_code Filter::solve(const Seam&, Signal&);
#endif

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_IMPL_H
