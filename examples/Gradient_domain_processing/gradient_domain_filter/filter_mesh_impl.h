// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_FILTER_MESH_IMPL_H
#define GRADIENT_DOMAIN_FILTER_FILTER_MESH_IMPL_H

#include "filter_parts.h"
#include "filter_signal.h"
#include "normals.h"

#include <CGAL/Gradient_domain_processing/enhance_details.h>
#include <CGAL/Gradient_domain_processing/estimate_curvatures.h>
#include <CGAL/Gradient_domain_processing/fit_to_normals.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace filter_mesh_impl {

template <class SparseLinearSolver>
class Filter
{
  const Options& m_options;
  Mesh_file& m_file;
  Stage_clock& m_clock;
  Filter_facts& m_facts;
  Filter_input m_input;
  SparseLinearSolver m_solver; // shares its state with the one that works

public:
  Filter(const Options& options, Mesh_file& file, Stage_clock& clock, Filter_facts& facts,
         const SparseLinearSolver& solver = SparseLinearSolver())
    : m_options(options), m_file(file), m_clock(clock), m_facts(facts), m_input(options, file), m_solver(solver) {}

  SparseLinearSolver& solver() { return m_solver; }

  Error_code run()
  {
    const Options& o = m_options;
    const std::vector<double>* const alpha =
      o.value_weight_property.empty() ? nullptr : &vertex_property(o, m_file, o.value_weight_property);
    const std::vector<double> beta = at_faces(o, m_file, o.gradient_weight_property),
                              lambda = at_faces(o, m_file, o.gradient_scale_property);
    const auto weight_map = [](const std::vector<double>& values, double constant) {
      return Weight_map{values.empty() ? nullptr : &values, constant};
    };
    const auto np = common_parameters(o, m_input, m_clock, m_solver)
      .vertex_value_weight_map(Weight_map{alpha, o.value_weight})
      .face_gradient_weight_map(weight_map(beta, o.gradient_weight))
      .face_gradient_scale_map(weight_map(lambda, o.gradient_scale))
      .gradient_scale(o.gradient_scale)
      .hessian_weight(o.hessian_weight)
      .curvature_metric_kind(o.metric)
      .curvature_weight(o.curvature_weight)
      .curvature_estimator(o.curvature)
      .jet_degree(o.jet_degree)
      .presmoothing_weight(o.presmoothing_weight)
      .number_of_iterations(o.iterations)
      .non_shrinking_order(o.non_shrinking)
      .normal_projection_weight(o.normal_projection_weight)
      .normal_fit_kind(o.normal_fit)
      .sharpening_weight(o.sharpening_weight)
      .sharpening_scale(o.sharpening_scale)
      .missing_values(o.has_missing_values)
      .restore_volume(o.restores_volume);
    if(o.signal == Signal_kind::CURVATURE)
      return write_curvature(np);
    if(o.signal == Signal_kind::NORMAL_TO_POSITION)
      return fit_to_normals(np);
    std::vector<Vector> normals = o.has_metric() ? vertex_normals_of_file(m_file) : std::vector<Vector>();
    if(normals.empty())
      return run_on(np);
    return run_on(np.vertex_normal_map(Array_map<Vector>{&normals}));
  }

private:

  template <class NamedParameters>
  Error_code run_on(const NamedParameters& np)
  {
    if(m_options.operation == Operation::ENHANCE_DETAILS)
      return in_region(m_input, m_facts, [&](const auto&... faces) {
        return GDP::enhance_details(faces..., m_file.points, m_file.polygons, np);
      });
    const auto with_filter = [&](const auto& body) { return with_solver(np, body); };
    switch(m_options.signal)
    {
      case Signal_kind::NORMAL: return filter_normals(m_options, m_file, with_filter);
      case Signal_kind::COLOR: return filter_colors(m_options, m_file, with_filter);
      case Signal_kind::PROPERTY: return filter_properties(m_options, m_file, with_filter);
      default:
        return in_region(m_input, m_facts, [&](const auto&... faces) {
          return GDP::smooth(faces..., m_file.points, m_file.polygons, np);
        });
    }
  }

  template <class NamedParameters>
  Error_code fit_to_normals(const NamedParameters& np)
  {
    std::vector<Vector> normals;
    for(const Three_channels& n : normal_signal(m_options, m_file))
      normals.emplace_back(n[0], n[1], n[2]);
    return in_region(m_input, m_facts, [&](const auto&... faces) {
      return GDP::fit_to_normals(faces..., m_file.points, m_file.polygons, Array_map<Vector>{&normals}, np);
    });
  }

  // All channels share a factorization.
  template <class NamedParameters, class Body>
  Error_code with_solver(const NamedParameters& np, const Body& body)
  {
    return in_region(m_input, m_facts, [&](const auto&... faces) {
      auto solver = GDP::make_gradient_domain_solver(faces..., m_file.points, m_file.polygons, np);
      return body([&](auto& values) {
        const Array_map<typename std::decay_t<decltype(values)>::value_type> map{&values};
        const auto missing_before = number_of_missing(values);
        const Error_code code = solver.filter(map, map, m_options.iterations);
        if(const auto filled = missing_before - number_of_missing(values); code == GDP::ok && filled > 0)
          m_clock.notice(std::to_string(filled) + (filled == 1 ? " missing value was" : " missing values were")
                         + " filled in");
        return code;
      });
    });
  }

  static std::ptrdiff_t number_of_missing(const std::vector<double>& values)
  {
    return std::count_if(values.begin(), values.end(), [](double x) { return std::isnan(x); });
  }
  static std::ptrdiff_t number_of_missing(const std::vector<Three_channels>&) { return 0; }

  template <class NamedParameters>
  Error_code write_curvature(const NamedParameters& np)
  {
    typedef GDP::Principal_curvatures_and_directions<Kernel> Curvature;
    std::vector<Curvature> curvatures(m_file.points.size(), Curvature{0, 0, Vector(0, 0, 0), Vector(0, 0, 0)});
    if(const Error_code code =
         GDP::estimate_curvatures(m_file.points, m_file.polygons, Array_map<Curvature>{&curvatures}, np))
      return code;
    std::vector<double> total;
    for(const Curvature& k : curvatures)
    {
      total.push_back(k.min_curvature * k.min_curvature + k.max_curvature * k.max_curvature);
      if(!std::isfinite(total.back()))
        return GDP::error_result_out_of_range;
    }
    set_curvature(total, m_file);
    return GDP::ok;
  }
};

} // namespace filter_mesh_impl

#endif // GRADIENT_DOMAIN_FILTER_FILTER_MESH_IMPL_H
