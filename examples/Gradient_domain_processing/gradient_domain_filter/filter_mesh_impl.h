// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_FILTER_MESH_IMPL_H
#define GRADIENT_DOMAIN_FILTER_FILTER_MESH_IMPL_H

#include "Failure.h"
#include "filter_mesh.h"
#include "normals.h"
#include "signal.h"

#include <CGAL/Gradient_domain_processing/denoise.h>
#include <CGAL/Gradient_domain_processing/enhance_details.h>
#include <CGAL/Gradient_domain_processing/estimate_curvatures.h>
#include <CGAL/Gradient_domain_processing/fit_to_normals.h>
#include <CGAL/Gradient_domain_processing/process_face_signal.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace filter_mesh_impl {

namespace GDP = CGAL::Gradient_domain_processing;
using GDP::Error_code;

// Property maps over arrays that are indexed by the vertices or faces.
template <class Value>
struct Array_map
{
  typedef std::size_t key_type;
  typedef Value value_type;
  typedef const Value& reference;
  typedef boost::lvalue_property_map_tag category;

  std::vector<Value>* values;

  friend const Value& get(const Array_map& map, std::size_t key) { return (*map.values)[key]; }
  friend void put(const Array_map& map, std::size_t key, const Value& value) { (*map.values)[key] = value; }
};

// A weight: that of a property, or one for all.
struct Weight_map
{
  typedef std::size_t key_type;
  typedef double value_type;
  typedef double reference;
  typedef boost::readable_property_map_tag category;

  const std::vector<double>* values; // none: the constant
  double constant;

  friend double get(const Weight_map& map, std::size_t key) { return map.values ? (*map.values)[key] : map.constant; }
};

// What a pack of named parameters holds is known when compiled, and every pack is a compilation of its own. So weights are
// masks always, constant ones if need be; only where the library asks whether a name is there do packs differ.
template <class SparseLinearSolver>
class Filter
{
  const Options& m_options;
  Mesh_file& m_file;
  Stage_clock& m_clock;
  Filter_facts& m_facts;
  SparseLinearSolver m_solver; // shares its state with the one that works

public:
  Filter(const Options& options, Mesh_file& file, Stage_clock& clock, Filter_facts& facts)
    : m_options(options), m_file(file), m_clock(clock), m_facts(facts) {}

  SparseLinearSolver& solver() { return m_solver; }

  Error_code run()
  {
    std::vector<char> is_constrained(m_file.points.size(), 0);
    if(!m_options.constrained_property.empty())
    {
      const std::vector<double>& selected = vertex_property(m_options, m_file, m_options.constrained_property);
      std::transform(selected.begin(), selected.end(), is_constrained.begin(), [](double x) { return x != 0; });
    }
    const auto np = GDP::parameters::sparse_linear_solver(m_solver)
      .visitor(std::ref(m_clock))
      .area_normalization(m_options.area_normalization)
      .border_condition(m_options.border)
      .movable_axes(movable_axes())
      .max_displacement(m_options.max_displacement.value_or(std::numeric_limits<double>::infinity()))
      .vertex_is_constrained_map(Array_map<char>{&is_constrained});
    const auto run_welded = [this](const auto& pack) {
      return m_options.operation == Operation::DENOISE ? denoise(pack) : filter(pack);
    };
    return m_options.weld_tolerance ? run_welded(np.weld_tolerance(*m_options.weld_tolerance)) : run_welded(np);
  }

private:
  std::string movable_axes() const
  {
    std::string axes;
    for(std::size_t i = 0; i < 3; ++i)
      if(m_options.moves_along[i])
        axes += "xyz"[i];
    return axes;
  }

  // A vertex property at the faces, as the mean of the corners; empty without a name.
  std::vector<double> at_faces(const std::string& name) const
  {
    std::vector<double> values;
    if(name.empty())
      return values;
    const std::vector<double>& at_vertices = vertex_property(m_options, m_file, name);
    values.reserve(m_file.polygons.size());
    for(const auto& polygon : m_file.polygons)
    {
      double sum = 0;
      for(int v : polygon)
        sum += at_vertices[std::size_t(v)];
      values.push_back(sum / double(polygon.size()));
    }
    return values;
  }

  // The faces all of whose vertices are selected.
  std::vector<std::size_t> region() const
  {
    const std::vector<double>& selected = vertex_property(m_options, m_file, m_options.region_property);
    std::vector<std::size_t> faces;
    for(std::size_t f = 0; f < m_file.polygons.size(); ++f)
    {
      const auto polygon = m_file.polygons[f];
      if(std::all_of(polygon.begin(), polygon.end(), [&](int v) { return selected[std::size_t(v)] != 0; }))
        faces.push_back(f);
    }
    return faces;
  }

  // Calls verb(), or verb(region) where there is one.
  template <class Verb>
  Error_code in_region(const Verb& verb)
  {
    if(m_options.region_property.empty())
      return verb();
    const std::vector<std::size_t> faces = region();
    if(faces.empty())
      m_facts.why_unchanged = "the region is empty: no face has three vertices where '" + m_options.region_property + "' is not 0";
    return faces.empty() ? GDP::ok : verb(faces);
  }

  template <class NamedParameters>
  Error_code denoise(const NamedParameters& np)
  {
    GDP::Denoising_summary summary;
    const auto all = np.denoising_summary(std::ref(summary))
      .noise_level(m_options.noise_level)
      .noise_scale(m_options.noise_scale)
      .value_weight(m_options.denoising_value_weight.value_or(0.05));
    const auto run = [&](const auto& pack) {
      return in_region([&](const auto&... faces) { return GDP::denoise(faces..., m_file.points, m_file.polygons, pack); });
    };
    const auto with_volume = [&](const auto& pack) { return m_options.restores_volume ? run(pack.restore_volume(true)) : run(pack); };
    const Error_code code = m_options.passes ? with_volume(all.number_of_iterations(*m_options.passes)) : with_volume(all);
    m_facts.found = {{"noise_level", summary.noise_level}, {"noise_share", summary.noise_share}, {"noise_scale", summary.noise_scale},
                     {"roughness_level", summary.roughness_level}, {"outliers", double(summary.number_of_outliers)},
                     {"passes", double(summary.number_of_iterations)}};
    if(summary.end == GDP::Denoising_end::no_noise)
      m_facts.why_unchanged = "no noise was found (--noise-level names it, in radians; the faces have a roughness of "
                              + std::to_string(summary.roughness_level) + ")";
    return code;
  }

  template <class NamedParameters>
  Error_code filter(const NamedParameters& np)
  {
    const Options& o = m_options;
    const std::vector<double>* const alpha = o.value_weight_property.empty() ? nullptr : &vertex_property(o, m_file, o.value_weight_property);
    const std::vector<double> beta = at_faces(o.gradient_weight_property), lambda = at_faces(o.gradient_scale_property);
    const auto weight_map = [](const std::vector<double>& values, double constant) {
      return Weight_map{values.empty() ? nullptr : &values, constant};
    };
    const auto all = np.vertex_value_weight_map(Weight_map{alpha, o.value_weight})
      .face_gradient_weight_map(weight_map(beta, o.gradient_weight))
      .face_gradient_scale_map(weight_map(lambda, o.gradient_scale))
      .gradient_scale(o.gradient_scale)
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
      return write_curvature(all);
    std::vector<Vector> normals = vertex_normals_of_file(m_file);
    if(normals.empty())
      return run_on(all);
    return run_on(all.vertex_normal_map(Array_map<Vector>{&normals}));
  }

  template <class NamedParameters>
  Error_code run_on(const NamedParameters& np)
  {
    if(m_options.operation == Operation::ENHANCE_DETAILS)
      return in_region([&](const auto&... faces) { return GDP::enhance_details(faces..., m_file.points, m_file.polygons, np); });
    switch(m_options.signal)
    {
      case Signal_kind::NORMAL: return filter_normals(np);
      case Signal_kind::COLOR: return filter_colors(np);
      case Signal_kind::PROPERTY: return filter_properties(np);
      case Signal_kind::NORMAL_TO_POSITION: return fit_to_normals(np);
      default: return in_region([&](const auto&... faces) { return GDP::smooth(faces..., m_file.points, m_file.polygons, np); });
    }
  }

  template <class NamedParameters>
  Error_code fit_to_normals(const NamedParameters& np)
  {
    std::vector<Vector> normals;
    for(const Three_channels& n : normal_signal(m_options, m_file))
      normals.emplace_back(n[0], n[1], n[2]);
    return in_region([&](const auto&... faces) {
      return GDP::fit_to_normals(faces..., m_file.points, m_file.polygons, Array_map<Vector>{&normals}, np);
    });
  }

  // Normals, colors and properties are reals here, whatever the file made of them. All share a factorization.
  template <class NamedParameters, class Filtering>
  Error_code with_solver(const NamedParameters& np, const Filtering& filtering)
  {
    return in_region([&](const auto&... faces) {
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
    const Property_signal signal = property_signal(m_options, m_file);
    std::vector<std::vector<double> > values;
    for(const Column* column : signal.columns)
      values.push_back(column->values);
    const auto keep = [&] {
      for(std::size_t i = 0; i < values.size(); ++i)
      {
        signal.columns[i]->values = values[i];
        signal.columns[i]->is_changed = true;
      }
      return GDP::ok;
    };
    if(signal.is_at_faces)
    {
      for(std::vector<double>& v : values)
        if(const Error_code code = filter_face_signal(np, v))
          return code;
      return keep();
    }
    return with_solver(np, [&](const auto& filtered) {
      for(std::vector<double>& v : values)
        if(const Error_code code = filtered(v))
          return code;
      return keep();
    });
  }

  template <class NamedParameters>
  Error_code filter_face_signal(const NamedParameters& np, std::vector<double>& values)
  {
    if(!m_options.region_property.empty())
      throw Failure(m_options.input_name(), "--region works on signals of vertices, and '" + m_options.signal_name + "' is one of faces");
    if(m_options.has_missing_values)
      throw Failure(m_options.input_name(), "--missing-values works on signals of vertices, and '" + m_options.signal_name + "' is one of faces");
    const Array_map<double> map{&values};
    for(int i = 0; i < m_options.iterations; ++i)
      if(const Error_code code = GDP::process_face_signal(m_file.points, m_file.polygons, map, map, np))
        return code;
    return GDP::ok;
  }

  template <class NamedParameters>
  Error_code write_curvature(const NamedParameters& np)
  {
    typedef GDP::Principal_curvatures_and_directions<Kernel> Curvature;
    std::vector<Curvature> curvatures(m_file.points.size(), Curvature{0, 0, Vector(0, 0, 0), Vector(0, 0, 0)});
    if(const Error_code code = GDP::estimate_curvatures(m_file.points, m_file.polygons, Array_map<Curvature>{&curvatures}, np))
      return code;
    std::vector<double> total;
    for(const Curvature& k : curvatures)
      total.push_back(k.min_curvature * k.min_curvature + k.max_curvature * k.max_curvature);
    set_curvature(total, m_file);
    return GDP::ok;
  }
};

} // namespace filter_mesh_impl

#endif // GRADIENT_DOMAIN_FILTER_FILTER_MESH_IMPL_H
