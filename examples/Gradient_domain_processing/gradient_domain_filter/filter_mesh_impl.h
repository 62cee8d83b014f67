// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_FILTER_MESH_IMPL_H
#define GRADIENT_DOMAIN_FILTER_FILTER_MESH_IMPL_H

#include "filter_parts.h"
#include "normals.h"

#include <CGAL/Gradient_domain_processing/enhance_details.h>
#include <CGAL/Gradient_domain_processing/estimate_curvatures.h>
#include <CGAL/Gradient_domain_processing/fit_to_normals.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <algorithm>
#include <cmath>
#include <string>

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
  Filter(const Options& options, Mesh_file& file, Stage_clock& clock, Filter_facts& facts)
    : m_options(options), m_file(file), m_clock(clock), m_facts(facts), m_input(options, file) {}

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
    switch(m_options.signal)
    {
      case Signal_kind::NORMAL: return filter_normals(np);
      case Signal_kind::COLOR: return filter_colors(np);
      case Signal_kind::PROPERTY: return filter_properties(np);
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

  // Normals, colors and properties are reals here, whatever the file made of them. All share a factorization.
  template <class NamedParameters, class Filtering>
  Error_code with_solver(const NamedParameters& np, const Filtering& filtering)
  {
    return in_region(m_input, m_facts, [&](const auto&... faces) {
      auto solver = GDP::make_gradient_domain_solver(faces..., m_file.points, m_file.polygons, np);
      return filtering([&](auto& values) {
        const Array_map<typename std::decay_t<decltype(values)>::value_type> map{&values};
        return solver.filter(map, map, m_options.iterations);
      });
    });
  }

  template <class NamedParameters>
  Error_code filter_normals(const NamedParameters& np)
  {
    std::vector<Three_channels> normals = normal_signal(m_options, m_file);
    return with_solver(np, [&](const auto& filtered) {
      const Error_code code = filtered(normals);
      if(code == GDP::ok)
        set_normal_signal(m_options, normals, m_file);
      return code;
    });
  }

  template <class NamedParameters>
  Error_code filter_colors(const NamedParameters& np)
  {
    std::vector<Three_channels> colors = color_signal(m_options, m_file);
    const Column* const column = m_file.vertex_columns.find("alpha");
    std::vector<double> alpha = column ? column->values : std::vector<double>();
    return with_solver(np, [&](const auto& filtered) {
      if(const Error_code code = filtered(colors))
        return code;
      if(const Error_code code = alpha.empty() ? GDP::ok : filtered(alpha))
        return code;
      set_color_signal(colors, alpha, m_file);
      return GDP::ok;
    });
  }

  template <class NamedParameters>
  Error_code filter_properties(const NamedParameters& np)
  {
    Property_signal signal = property_signal(m_options, m_file);
    return with_solver(np, [&](const auto& filtered) {
      for(std::vector<double>& values : signal.values)
      {
        const auto missing = [&] {
          return std::count_if(values.begin(), values.end(), [](double x) { return std::isnan(x); });
        };
        const auto before = missing();
        if(const Error_code code = filtered(values))
          return code;
        if(const auto filled = before - missing(); filled > 0)
          m_clock.notice(std::to_string(filled) + (filled == 1 ? " missing value was" : " missing values were")
                         + " filled in");
      }
      signal.set();
      return GDP::ok;
    });
  }

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
