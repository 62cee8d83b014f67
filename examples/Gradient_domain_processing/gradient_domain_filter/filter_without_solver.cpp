// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Failure.h"
#include "filter_parts.h"

#include <CGAL/Gradient_domain_processing/denoise.h>
#include <CGAL/Gradient_domain_processing/process_face_signal.h>

#include <cstdio>

// What the library solves without a solver of ours: compiled once.
namespace {

using namespace filter_mesh_impl;

std::string rounded(double x)
{
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.3g", x);
  return buffer;
}

} // namespace

Error_code denoise_mesh(const Options& options, Mesh_file& file, Stage_clock& clock, Filter_facts& facts)
{
  Filter_input input(options, file);
  GDP::Denoising_summary summary;
  const auto np = common_parameters(options, input, clock, GDP::Default_sparse_linear_solver())
    .denoising_summary(std::ref(summary))
    .noise_level(options.noise_level)
    .noise_scale(options.noise_scale);
  const auto run = [&](const auto& pack) {
    return in_region(input, facts,
                     [&](const auto&... faces) { return GDP::denoise(faces..., file.points, file.polygons, pack); });
  };
  const auto run_passes = [&](const auto& pack) {
    return options.passes ? run(pack.number_of_iterations(*options.passes)) : run(pack);
  };
  const Error_code code = options.denoising_value_weight ? run_passes(np.value_weight(*options.denoising_value_weight))
                                                         : run_passes(np);
  facts.solver = "cg";
  facts.found = {{"noise_level", summary.noise_level},
                 {"noise_share", summary.noise_share},
                 {"noise_scale", summary.noise_scale},
                 {"roughness_level", summary.roughness_level},
                 {"outliers", double(summary.number_of_outliers)},
                 {"passes", double(summary.number_of_iterations)}};
  if(summary.end == GDP::Denoising_end::no_noise && facts.why_unchanged.empty())
    facts.why_unchanged =
      "no noise was found"
      + (summary.roughness_level > 0 ? "; the roughness of the faces is " + rounded(summary.roughness_level)
                                         + ", which --noise-level takes for noise"
                                     : std::string());
  return code;
}

Error_code filter_face_properties(const Options& options, Mesh_file& file, Stage_clock& clock, Filter_facts& facts)
{
  const auto refuse = [&](bool is_given, const char* option) {
    if(is_given)
      throw Failure(options.input_name(), std::string(option) + " works on signals of vertices, and '"
                                            + options.signal_name + "' is one of faces");
  };
  refuse(!options.constrained_property.empty(), "--constrain");
  refuse(!options.value_weight_property.empty(), "--value-weight-property");
  refuse(!options.gradient_weight_property.empty(), "--gradient-weight-property");
  refuse(!options.gradient_scale_property.empty(), "--gradient-scale-property");
  refuse(options.has_missing_values, "--missing-values");
  refuse(options.has_metric(), "--metric");
  refuse(options.non_shrinking > 1, "--non-shrinking");
  refuse(options.hessian_weight > 0, "--hessian-weight");
  refuse(options.border != GDP::Border_condition::FREE, "--border");
  refuse(options.non_manifold != GDP::Border_condition::FREE, "--non-manifold");
  Filter_input input(options, file);
  Property_signal signal = property_signal(options, file);
  const auto np = common_parameters(options, input, clock, GDP::Default_sparse_linear_solver())
    .value_weight(options.value_weight)
    .gradient_weight(options.gradient_weight)
    .gradient_scale(options.gradient_scale);
  facts.solver = "cg";
  for(std::vector<double>& values : signal.values)
    for(int i = 0; i < options.iterations; ++i)
    {
      const Array_map<double> map{&values};
      const auto run = [&](const auto&... faces) {
        return GDP::process_face_signal(faces..., file.points, file.polygons, map, map, np);
      };
      if(const Error_code code = in_region(input, facts, run))
        return code;
    }
  signal.set();
  return GDP::ok;
}
