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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_READ_PARAMETERS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_READ_PARAMETERS_H

#include <CGAL/Gradient_domain_processing/parameters.h>
#include <CGAL/Gradient_domain_processing/internal/curvature/estimates.h>
#include <CGAL/Gradient_domain_processing/internal/curvature/tangent_frame.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/Filter.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/arrange.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/signals.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Named parameters become plain numbers and arrays here.

// Numbers at elements, checked; ends with the first bad one.
template <class Map, class Elements>
bool read_numbers(Map map, const Elements& elements, bool is_non_negative, std::vector<double>& numbers)
{
  numbers.reserve(elements.size());
  for(auto element : elements)
  {
    numbers.push_back(CGAL::to_double(get(map, element)));
    if(!std::isfinite(numbers.back()) || (is_non_negative && numbers.back() < 0))
      return false;
  }
  return true;
}

// Numbers that are all the same become `same`, and none of their own: that is what costs least.
std::vector<double> unless_constant(std::vector<double> numbers, double& same);

// From rows to vertices, as their mean; virtual vertices have that of their corners.
std::vector<double> at_vertices(const Indexed_triangles& mesh, std::vector<double> at_rows);

std::vector<double> at_triangles(const Indexed_triangles& mesh, std::vector<double> at_faces);

template <class NamedParameters>
Reading reading_parameters(const NamedParameters& np)
{
  using namespace CGAL::internal_np;
  Reading reading;
  reading.parallel = is_parallel<Parameter_type<concurrency_tag_t, NamedParameters, Parallel_if_available_tag> >();
  reading.weld_tolerance = parameter(np, weld_tolerance, -1.);
  reading.welds = reading.weld_tolerance >= 0;
  return reading;
}

// alpha, beta and lambda.
template <class Surface, class NamedParameters>
Error_code read_weights(const NamedParameters& np, const Surface_elements<Surface>& elements, Filter& filter)
{
  using namespace CGAL::internal_np;
  Energy_weights weights;
  double beta = parameter(np, gradient_weight, 1e-4);
  const double gamma = parameter(np, hessian_weight, 0.);
  weights.value = parameter(np, value_weight, 1.);
  weights.scale = parameter(np, gradient_scale, 0.);
  if(!is_weight(weights.value) || !is_weight(beta) || !is_weight(gamma) || !std::isfinite(weights.scale))
    return error_invalid_weight;
  const auto is_bad = [](const std::vector<double>& numbers, int& culprit) {
    culprit = int(numbers.size()) - 1;
    return error_invalid_weight;
  };
  std::vector<double> numbers;
  if constexpr (Has_parameter<vertex_value_weight_map_t, NamedParameters>::value)
  {
    if(!read_numbers(parameter(np, vertex_value_weight_map, 0), elements.vertices, true, numbers))
      return is_bad(numbers, filter.culprit.row);
    weights.value_at_vertex = unless_constant(at_vertices(filter.mesh(), std::move(numbers)), weights.value);
    numbers.clear();
  }
  if constexpr (Has_parameter<face_gradient_weight_map_t, NamedParameters>::value)
  {
    if(!read_numbers(parameter(np, face_gradient_weight_map, 0), elements.faces, true, numbers))
      return is_bad(numbers, filter.culprit.face);
    weights.gradient_at_triangle = unless_constant(at_triangles(filter.mesh(), std::move(numbers)), beta);
    for(double& w : weights.gradient_at_triangle)
      w *= filter.squared_length_unit;
    numbers.clear();
  }
  if constexpr (Has_parameter<face_gradient_scale_map_t, NamedParameters>::value)
  {
    if(!read_numbers(parameter(np, face_gradient_scale_map, 0), elements.faces, false, numbers))
      return is_bad(numbers, filter.culprit.face);
    weights.scale_at_triangle = unless_constant(at_triangles(filter.mesh(), std::move(numbers)), weights.scale);
  }
  weights.gradient = beta * filter.squared_length_unit;
  filter.set_second_order(gamma * filter.squared_length_unit * filter.squared_length_unit,
                          parameter(np, hessian_kind, Hessian_kind::SQUARED_HESSIAN));
  filter.system.set_weights(weights);
  return ok;
}

// Vertices that the caller constrains, beside those that are already.
template <class Surface, class NamedParameters>
void read_constraints(const NamedParameters& np, const Surface_elements<Surface>& elements,
                      std::vector<char> is_constrained, Filter& filter)
{
  using namespace CGAL::internal_np;
  is_constrained.resize(filter.mesh().points.size(), 0);
  if constexpr (Has_parameter<vertex_is_constrained_t, NamedParameters>::value)
  {
    const auto map = parameter(np, vertex_is_constrained, 0);
    for(std::size_t row = 0; row < elements.vertices.size(); ++row)
      if(get(map, elements.vertices[row]))
        is_constrained[filter.mesh().vertex_of(int(row))] = 1;
  }
  filter.border_condition = parameter(np, border_condition, Border_condition::FREE);
  filter.line_condition = parameter(np, non_manifold_condition, Border_condition::FREE);
  filter.constrain(std::move(is_constrained));
}

// How curvature is estimated, with the caller's normals if there are any.
template <class Surface, class NamedParameters>
Error_code read_curvature_options(const NamedParameters& np, const Surface_elements<Surface>& elements, Filter& filter,
                                  double default_presmoothing_weight, Curvature_options& options)
{
  using namespace CGAL::internal_np;
  options.estimator = parameter(np, curvature_estimator, Curvature_estimator::JETS);
  options.jet_degree = parameter(np, jet_degree, 2);
  const double weight = parameter(np, presmoothing_weight, default_presmoothing_weight);
  options.presmoothing_weight = weight * filter.squared_length_unit;
  if(options.jet_degree < 2 || options.jet_degree > 4)
    return error_invalid_parameter;
  if(!is_weight(weight))
    return error_invalid_weight;
  if constexpr (Has_parameter<vertex_normal_map_t, NamedParameters>::value)
  {
    Signal normals;
    if(const Error_code code =
         read_vectors(parameter(np, vertex_normal_map, 0), elements, filter.mesh(), filter.culprit, normals))
      return code;
    options.normals = mean_over_rows(filter.mesh(), normals);
  }
  return ok;
}

// The caller's curvatures, in units of the arrays.
template <class Map, class Surface>
Error_code read_curvatures(Map map, const Surface_elements<Surface>& elements, const Indexed_triangles& mesh,
                           Culprit& culprit, std::vector<Principal_curvatures>& curvatures)
{
  const double unit = mesh.unit();
  curvatures.assign(mesh.points.size(), flat_curvatures(frame_of_normal(Vec3::Zero())));
  for(std::size_t row = 0; row < elements.vertices.size(); ++row)
  {
    const auto& k = get(map, elements.vertices[row]);
    const Principal_curvatures at_row = {unit * CGAL::to_double(k.min_curvature),
                                         unit * CGAL::to_double(k.max_curvature), to_vec3(k.min_direction),
                                         to_vec3(k.max_direction)};
    if(!std::isfinite(at_row.min_curvature) || !std::isfinite(at_row.max_curvature) || !at_row.min_direction.allFinite()
       || !at_row.max_direction.allFinite())
    {
      culprit.row = int(row);
      return error_invalid_target;
    }
    curvatures[mesh.vertex_of(int(row))] = at_row;
  }
  return ok;
}

template <class Surface, class NamedParameters>
Error_code triangle_curvatures(const NamedParameters& np, const Surface_elements<Surface>& elements, Filter& filter,
                               std::vector<Principal_curvatures>& curvatures)
{
  using namespace CGAL::internal_np;
  if constexpr (Has_parameter<vertex_curvature_map_t, NamedParameters>::value)
  {
    std::vector<Principal_curvatures> at_vertices;
    if(const Error_code code =
         read_curvatures(parameter(np, vertex_curvature_map, 0), elements, filter.mesh(), filter.culprit, at_vertices))
      return code;
    curvatures = triangle_curvatures(filter.mesh(), filter.system.parallel, at_vertices);
    return ok;
  }
  else
  {
    Curvature_options options;
    if(const Error_code code = read_curvature_options(np, elements, filter, 1e-4, options))
      return code;
    return filter.estimate(options, curvatures);
  }
}

// The caller's tensors, in units of the arrays.
template <class Map, class Surface>
Error_code read_metrics(Map map, const Surface_elements<Surface>& elements, Filter& filter)
{
  if(const Error_code code = filter.ready())
    return code;
  Stage_scope stage(filter.progress(), Stage::METRIC);
  const Indexed_triangles& mesh = filter.mesh();
  if(mesh.virtual_vertices.size() > 0)
    return error_non_triangular_mesh;
  Untouched_vector<Triangle_metric> metrics(mesh.triangles.size());
  const double factor = 1 / (mesh.unit() * mesh.unit());
  for(std::size_t f = 0; f < metrics.size(); ++f)
  {
    const Triangle_metric metric = get(map, elements.faces[mesh.face_of(int(f))]);
    metrics[f] = metric.scaled(factor).with_area_bounded_below(degeneracy_ratio);
    if(!metric.is_valid() || !metrics[f].is_valid())
    {
      filter.culprit.face = mesh.face_of(int(f));
      return error_invalid_metric;
    }
  }
  filter.system.set_metrics(std::move(metrics));
  return ok;
}

template <class Kind, class Surface, class NamedParameters>
Error_code set_curvature_metric(const Kind& kind, double weight, const NamedParameters& np,
                                const Surface_elements<Surface>& elements, Filter& filter)
{
  Stretch stretch;
  if constexpr (std::is_same<Kind, Curvature_metric_kind>::value)
  {
    if(!is_weight(weight))
      return error_invalid_weight;
    if(kind == Curvature_metric_kind::EMBEDDING || weight == 0)
    {
      filter.system.set_embedding_metric();
      return ok;
    }
    stretch = Curvature_stretch{kind, weight * filter.squared_length_unit};
  }
  else
  {
    const double unit = filter.mesh().unit();
    stretch = [kind, unit](double k1, double k2) { return kind(k1 / unit, k2 / unit); };
  }
  std::vector<Principal_curvatures> curvatures;
  if(const Error_code code = triangle_curvatures(np, elements, filter, curvatures))
    return code;
  return filter.set_curvature_metric(curvatures, stretch);
}

// The metric that the parameters describe.
template <class Surface, class NamedParameters>
Error_code set_metric(const NamedParameters& np, const Surface_elements<Surface>& elements, Filter& filter)
{
  using namespace CGAL::internal_np;
  if constexpr (Has_parameter<face_metric_map_t, NamedParameters>::value)
    return read_metrics(parameter(np, face_metric_map, 0), elements, filter);
  else if constexpr(!Has_parameter<curvature_weight_t, NamedParameters>::value
                    && !Has_parameter<curvature_metric_kind_t, NamedParameters>::value)
  {
    filter.system.set_embedding_metric(); // known when compiled, which spares compiling the estimators
    return ok;
  }
  else
  {
    const auto kind =
      parameter(np, curvature_metric_kind,
                Has_parameter<curvature_weight_t, NamedParameters>::value ? Curvature_metric_kind::EDGE_AWARE
                                                                          : Curvature_metric_kind::EMBEDDING);
    return set_curvature_metric(kind, parameter(np, curvature_weight, 0.02), np, elements, filter);
  }
}

// Whether the parameters ask for a metric that curvature stretches.
template <class NamedParameters>
bool needs_curvature(const NamedParameters& np)
{
  using namespace CGAL::internal_np;
  typedef Parameter_type<curvature_metric_kind_t, NamedParameters, Curvature_metric_kind> Kind;
  if constexpr (!Has_parameter<curvature_metric_kind_t, NamedParameters>::value)
    return Has_parameter<curvature_weight_t, NamedParameters>::value && parameter(np, curvature_weight, 0.) != 0;
  else if constexpr (std::is_same<typename std::decay<Kind>::type, Curvature_metric_kind>::value)
    return parameter(np, curvature_metric_kind, Curvature_metric_kind::EMBEDDING) != Curvature_metric_kind::EMBEDDING
        && parameter(np, curvature_weight, 0.02) != 0;
  else
    return true;
}

// What a verb with these parameters is going to do, in usual durations.
template <class NamedParameters>
double planned_work(const NamedParameters& np)
{
  const double passes = (std::max)(1., double(parameter(np, CGAL::internal_np::number_of_iterations, 1)));
  double pass = 2 * usual_duration(Stage::ASSEMBLE) + usual_duration(Stage::FACTOR) + usual_duration(Stage::SOLVE);
  if(needs_curvature(np))
    pass += pass + usual_duration(Stage::CURVATURE) + usual_duration(Stage::METRIC);
  return usual_duration(Stage::READ) + usual_duration(Stage::ANALYZE) + usual_duration(Stage::WRITE) + passes * pass;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/filtering/read_parameters_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_READ_PARAMETERS_H
