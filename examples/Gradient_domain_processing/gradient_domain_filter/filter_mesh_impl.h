// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_FILTER_MESH_IMPL_H
#define GRADIENT_DOMAIN_FILTER_FILTER_MESH_IMPL_H

#include "Failure.h"
#include "filter_mesh.h"

#include <CGAL/Gradient_domain_processing/denoise.h>
#include <CGAL/Gradient_domain_processing/enhance_details.h>
#include <CGAL/Gradient_domain_processing/estimate_curvatures.h>
#include <CGAL/Gradient_domain_processing/fit_to_normals.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace filter_mesh_impl {

namespace GDP = CGAL::Gradient_domain_processing;
using GDP::Error_code;

// Property maps over arrays that are indexed by the vertices or faces.
template <class Key, class Value>
struct Array_map
{
  typedef Key key_type;
  typedef Value value_type;
  typedef const Value& reference;
  typedef boost::lvalue_property_map_tag category;

  std::vector<Value>* values;

  friend const Value& get(const Array_map& map, Key key) { return (*map.values)[std::size_t(key)]; }
  friend void put(const Array_map& map, Key key, const Value& value) { (*map.values)[std::size_t(key)] = value; }
};

template <class Value> using Vertex_map = Array_map<Mesh::Vertex_index, Value>;

// A weight: that of a property, or one for all.
template <class Key>
struct Weight_map
{
  typedef Key key_type;
  typedef double value_type;
  typedef double reference;
  typedef boost::readable_property_map_tag category;

  const std::vector<double>* values; // none: the constant
  double constant;

  friend double get(const Weight_map& map, Key key) { return map.values ? (*map.values)[std::size_t(key)] : map.constant; }
};

typedef std::array<double, 3> Three_channels;

const std::vector<double>& property(const Options& options, const Mesh_file& file, const std::string& name);
std::vector<Vector> vertex_normals(const Mesh_file& file);
void write_curvature(const std::vector<double>& total_curvature, Columns& columns);

// Three columns as one signal, and back.
inline std::vector<Three_channels> three_columns(const Columns& columns, const std::array<const char*, 3>& names)
{
  const Column* const c[3] = {columns.find(names[0]), columns.find(names[1]), columns.find(names[2])};
  std::vector<Three_channels> signal(c[0]->values.size());
  for(std::size_t v = 0; v < signal.size(); ++v)
    signal[v] = {{c[0]->values[v], c[1]->values[v], c[2]->values[v]}};
  return signal;
}

inline void set_columns(const std::vector<Three_channels>& signal, const std::array<const char*, 3>& names, Columns& columns)
{
  for(int i = 0; i < 3; ++i)
  {
    Column& column = columns.find_or_add(names[i], Number_type::DOUBLE, signal.size());
    for(std::size_t v = 0; v < signal.size(); ++v)
      column.values[v] = signal[v][i];
  }
}

constexpr std::array<const char*, 3> normal_names = {{"nx", "ny", "nz"}}, color_names = {{"red", "green", "blue"}};

// What a pack of named parameters holds is known when compiled, and every pack is a compilation of its own. So weights are
// masks always, constant ones if need be; only normals of the file make a second pack.
template <class SparseLinearSolver>
class Filter
{
  const Options& m_options;
  Mesh_file& m_file;
  Stage_clock& m_clock;
  SparseLinearSolver m_solver; // shares its state with the one that works

public:
  Filter(const Options& options, Mesh_file& file, Stage_clock& clock) : m_options(options), m_file(file), m_clock(clock) {}

  SparseLinearSolver& solver() { return m_solver; }

  Error_code run()
  {
    const Options& o = m_options;
    std::vector<char> is_constrained(m_file.mesh.number_of_vertices(), 0);
    if(!o.constrained_property.empty())
    {
      const std::vector<double>& selected = property(o, m_file, o.constrained_property);
      std::transform(selected.begin(), selected.end(), is_constrained.begin(), [](double x) { return x != 0; });
    }
    if(o.operation == Operation::DENOISE)
      return run_operation(GDP::parameters::sparse_linear_solver(m_solver)
        .visitor(std::ref(m_clock))
        .area_normalization(o.area_normalization)
        .number_of_iterations(o.passes > 0 ? o.passes : -1)
        .border_condition(o.border)
        .vertex_is_constrained_map(Vertex_map<char>{&is_constrained}), [this](const auto& np, const auto&... region) {
          return GDP::denoise(region..., this->m_file.mesh, np);
        });
    const std::vector<double>* const alpha = o.value_weight_property.empty() ? nullptr : &property(o, m_file, o.value_weight_property);
    const std::vector<double> beta = at_faces(o.gradient_weight_property), lambda = at_faces(o.gradient_scale_property);
    const auto weight_map = [](const std::vector<double>& values, double constant) {
      return Weight_map<Mesh::Face_index>{values.empty() ? nullptr : &values, constant};
    };
    return with_normals(GDP::parameters::sparse_linear_solver(m_solver)
      .visitor(std::ref(m_clock))
      .vertex_value_weight_map(Weight_map<Mesh::Vertex_index>{alpha, o.value_weight})
      .face_gradient_weight_map(weight_map(beta, o.gradient_weight))
      .face_gradient_scale_map(weight_map(lambda, o.gradient_scale))
      .gradient_scale(o.gradient_scale)
      .area_normalization(o.area_normalization)
      .curvature_metric_kind(o.metric)
      .curvature_weight(o.curvature_weight)
      .curvature_estimator(o.curvature)
      .jet_degree(o.jet_degree)
      .presmoothing_weight(o.presmoothing_weight)
      .number_of_iterations(o.iterations)
      .normal_projection_weight(o.normal_projection_weight)
      .sharpening_weight(o.sharpening_weight)
      .sharpening_scale(o.sharpening_scale)
      .border_condition(o.border)
      .restore_volume(o.restores_volume)
      .vertex_is_constrained_map(Vertex_map<char>{&is_constrained}));
  }

private:
  // A vertex property at the faces, as the mean of the corners; empty without a name.
  std::vector<double> at_faces(const std::string& name) const
  {
    std::vector<double> values;
    if(name.empty())
      return values;
    const std::vector<double>& at_vertices = property(m_options, m_file, name);
    const Mesh& mesh = m_file.mesh;
    values.reserve(mesh.number_of_faces());
    for(Mesh::Face_index f : mesh.faces())
    {
      double sum = 0;
      for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
        sum += at_vertices[std::size_t(v)];
      values.push_back(sum / 3);
    }
    return values;
  }

  template <class NamedParameters>
  Error_code with_normals(const NamedParameters& np)
  {
    const auto operation = [this](const auto& pack, const auto&... region) { return this->run_on(pack, region...); };
    if(!m_file.vertex_columns.has_normals())
      return run_operation(np, operation);
    std::vector<Vector> normals = vertex_normals(m_file);
    return run_operation(np.vertex_normal_map(Vertex_map<Vector>{&normals}), operation);
  }

  // Calls operation(np), or operation(np, region) where there is one.
  template <class NamedParameters, class Run>
  Error_code run_operation(const NamedParameters& np, const Run& operation)
  {
    if(m_options.signal == Signal_kind::CURVATURE)
      return write_curvature(np);
    if(m_options.region_property.empty())
      return operation(np);
    std::vector<Mesh::Face_index> region;
    const std::vector<double>& selected = property(m_options, m_file, m_options.region_property);
    const Mesh& mesh = m_file.mesh;
    for(Mesh::Face_index f : mesh.faces())
    {
      bool is_inside = true;
      for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
        is_inside = is_inside && selected[std::size_t(v)] != 0;
      if(is_inside)
        region.push_back(f);
    }
    return operation(np, region);
  }

  // With a region as last argument or without.
  template <class NamedParameters, class... Region>
  Error_code run_on(const NamedParameters& np, const Region&... region)
  {
    Mesh& mesh = m_file.mesh;
    if(m_options.operation == Operation::ENHANCE_DETAILS)
      return GDP::enhance_details(region..., mesh, np);
    switch(m_options.signal)
    {
      case Signal_kind::NORMAL: return filter_columns(np, normal_names, region...);
      case Signal_kind::COLOR: return filter_columns(np, color_names, region...);
      case Signal_kind::NORMAL_TO_POSITION:
      {
        std::vector<Vector> normals = vertex_normals(m_file);
        return GDP::fit_to_normals(region..., mesh, Vertex_map<Vector>{&normals}, np);
      }
      default: return GDP::smooth(region..., mesh, np);
    }
  }

  // Normals and colors are reals here, whatever the file made of them. All channels share a factorization.
  template <class NamedParameters, class... Region>
  Error_code filter_columns(const NamedParameters& np, const std::array<const char*, 3>& names, const Region&... region)
  {
    Columns& columns = m_file.vertex_columns;
    const bool is_color = names == color_names;
    if(is_color && !columns.has_colors())
      throw Failure(m_options.input, "no vertex colors");
    if(!is_color && !columns.has_normals())
    {
      const std::vector<Vector> normals = vertex_normals(m_file);
      for(int i = 0; i < 3; ++i)
      {
        Column& column = columns.find_or_add(names[i], Number_type::DOUBLE, normals.size());
        for(std::size_t v = 0; v < normals.size(); ++v)
          column.values[v] = normals[v][i];
      }
    }
    auto solver = GDP::make_gradient_domain_solver(region..., m_file.mesh, np);
    std::vector<Three_channels> signal = three_columns(columns, names);
    const Vertex_map<Three_channels> map{&signal};
    if(const Error_code code = solver.filter(map, map, m_options.iterations))
      return code;
    Column* const alpha = is_color ? columns.find("alpha") : nullptr;
    if(alpha)
    {
      const Vertex_map<double> alpha_map{&alpha->values};
      if(const Error_code code = solver.filter(alpha_map, alpha_map, m_options.iterations))
        return code;
    }
    set_columns(signal, names, columns);
    return GDP::OK;
  }

  template <class NamedParameters>
  Error_code write_curvature(const NamedParameters& np)
  {
    typedef GDP::Principal_curvatures_and_directions<Kernel> Curvature;
    std::vector<Curvature> curvatures(m_file.mesh.number_of_vertices());
    if(const Error_code code = GDP::estimate_curvatures(m_file.mesh, Vertex_map<Curvature>{&curvatures}, np))
      return code;
    std::vector<double> total;
    for(const Curvature& k : curvatures)
      total.push_back(k.min_curvature * k.min_curvature + k.max_curvature * k.max_curvature);
    filter_mesh_impl::write_curvature(total, m_file.vertex_columns);
    return GDP::OK;
  }
};

} // namespace filter_mesh_impl

#endif // GRADIENT_DOMAIN_FILTER_FILTER_MESH_IMPL_H
