// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "filter_parts.h"
#include "filter_signal.h"
#include "normals.h"
#include "seams.h"

#include <CGAL/Gradient_domain_processing/fair.h>
#include <CGAL/Gradient_domain_processing/filter_spectrum.h>
#include <CGAL/Gradient_domain_processing/spectrum.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

// The operations that are not of the paper: fair patches, bands of waves, harmonics.
namespace {

using namespace filter_mesh_impl;

GDP::Spectral_filter low_pass(const Options& o, double wavelength)
{
  return o.window ? GDP::Spectral_filter::windowed_low_pass(wavelength, o.filter_degree, *o.window)
                  : GDP::Spectral_filter::low_pass(wavelength, o.filter_order);
}

GDP::Spectral_filter band_pass(const Options& o, double a, double b)
{
  return o.window ? low_pass(o, (std::min)(a, b)).without(low_pass(o, (std::max)(a, b)))
                  : GDP::Spectral_filter::band_pass(a, b, o.filter_order);
}

GDP::Spectral_filter spectral_filter(const Options& o)
{
  const double a = o.wavelengths.front(), b = o.wavelengths.back();
  switch(o.operation)
  {
    case Operation::LOW_PASS: return low_pass(o, a);
    case Operation::HIGH_PASS: return low_pass(o, a).complement();
    case Operation::BAND_PASS: return band_pass(o, a, b);
    default: return band_pass(o, a, b).complement();
  }
}

template <class With_filter>
Error_code filter_positions(Mesh_file& file, const With_filter& with_filter)
{
  std::vector<Three_channels> positions;
  for(const Point& p : file.points)
    positions.push_back({{p.x(), p.y(), p.z()}});
  return with_filter([&](const auto& filtered) -> Error_code {
    if(const Error_code code = filtered(positions))
      return code;
    for(std::size_t v = 0; v < positions.size(); ++v)
      file.points[v] = Point(positions[v][0], positions[v][1], positions[v][2]);
    return GDP::ok;
  });
}

} // namespace

Error_code fair_mesh(const Options& options, Mesh_file& file, Stage_clock& clock, Filter_facts& facts)
{
  Filter_input input(options, file);
  const bool is_named = !options.region_vertices_property.empty(); // else all that are not constrained
  const std::string& name = is_named ? options.region_vertices_property : options.constrained_property;
  std::vector<std::size_t> region;
  const std::vector<double>& selected = vertex_property(options, file, name);
  for(std::size_t v = 0; v < selected.size(); ++v)
    if((selected[v] != 0) == is_named)
      region.push_back(v);
  if(region.empty())
    facts.why_unchanged =
      "the region is empty: " + (is_named ? "no vertex has another " + name + " than 0" : name + " is 0 at no vertex");
  facts.solver = default_solver_name();
  return GDP::fair(region, file.points, file.polygons,
                   common_parameters(options, input, clock, GDP::Default_sparse_linear_solver()));
}

Error_code filter_bands(const Options& options, Mesh_file& file, Stage_clock& clock, Filter_facts& facts)
{
  Filter_input input(options, file);
  const auto np = common_parameters(options, input, clock, GDP::Default_sparse_linear_solver())
    .curvature_metric_kind(options.metric)
    .curvature_weight(options.curvature_weight)
    .curvature_estimator(options.curvature)
    .jet_degree(options.jet_degree)
    .presmoothing_weight(options.presmoothing_weight);
  facts.solver = default_solver_name();
  const GDP::Spectral_filter filter = spectral_filter(options);
  const auto with_filter = [&](const auto& body) {
    return in_region(input, facts, [&](const auto&... faces) {
      return body([&](auto& values) {
        const Array_map<typename std::decay_t<decltype(values)>::value_type> map{&values};
        return GDP::filter_spectrum(faces..., file.points, file.polygons, map, map, filter, np);
      });
    });
  };
  switch(options.signal)
  {
    case Signal_kind::NORMAL: return filter_normals(options, file, with_filter);
    case Signal_kind::COLOR: return filter_colors(options, file, with_filter);
    case Signal_kind::PROPERTY: return filter_properties(options, file, with_filter);
    default: return filter_positions(file, with_filter);
  }
}

Error_code write_spectrum(const Options& options, Mesh_file& file, Stage_clock& clock, Filter_facts& facts)
{
  Filter_input input(options, file);
  std::vector<int> first(file.points.size());
  std::iota(first.begin(), first.end(), 0);
  if(options.weld_tolerance)
    first = first_in_place(file.points, file.polygons);
  Polygons polygons = file.polygons;
  for(int& v : polygons.corners)
    v = first[std::size_t(v)];
  std::size_t welded = 0;
  for(std::size_t v = 0; v < first.size(); ++v)
    if(first[v] != int(v))
    {
      ++welded;
      input.is_constrained[std::size_t(first[v])] |= input.is_constrained[v];
    }
  if(welded > 0)
    clock.notice(std::to_string(welded) + (welded == 1 ? " vertex at a seam was welded to another"
                                                       : " vertices at seams were welded to others"));
  Eigen::VectorXd eigenvalues;
  Eigen::MatrixXd harmonics;
  const auto np = GDP::parameters::vertex_is_constrained_map(Array_map<char>{&input.is_constrained});
  facts.solver = default_solver_name();
  const auto found = [&](const auto& all) {
    return GDP::spectrum(file.points, polygons, options.number_of_harmonics, eigenvalues, harmonics, all);
  };
  if(const Error_code code = options.spectral_shift ? found(np.spectral_shift(*options.spectral_shift)) : found(np))
    return code;
  facts.eigenvalues.assign(eigenvalues.data(), eigenvalues.data() + eigenvalues.size());
  for(int k = 0; k < int(harmonics.cols()); ++k)
  {
    Column& column =
      file.vertex_columns.find_or_add("harmonic_" + std::to_string(k), Number_type::DOUBLE, file.points.size());
    for(std::size_t v = 0; v < file.points.size(); ++v)
      column.values[v] = first[v] < int(harmonics.rows()) ? harmonics(first[v], k) : 0.;
    column.is_changed = true;
  }
  return GDP::ok;
}
