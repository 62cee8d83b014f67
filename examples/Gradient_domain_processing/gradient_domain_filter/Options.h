// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_OPTIONS_H
#define GRADIENT_DOMAIN_FILTER_OPTIONS_H

#include "files/Mesh_file.h"

#include <CGAL/Gradient_domain_processing/Spectral_filter.h>
#include <CGAL/Gradient_domain_processing/enum.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

enum class Operation { FILTER, ENHANCE_DETAILS, DENOISE, FAIR, LOW_PASS, HIGH_PASS, BAND_PASS, BAND_STOP, SPECTRUM };
enum class Signal_kind { POSITION, NORMAL, COLOR, NORMAL_TO_POSITION, CURVATURE, PROPERTY };
enum class Solver_kind { AUTO, EIGEN, CHOLMOD, CG };

// The command line.
struct Options
{
  std::string input, output, report;
  std::optional<File_format> input_format, output_format; // else by the name, or by what is in it
  Encoding encoding = Encoding::DEFAULT;
  Precision precision = Precision::DEFAULT;

  Operation operation = Operation::FILTER;
  Signal_kind signal = Signal_kind::POSITION;
  std::vector<std::string> signal_properties;
  double value_weight = 1, gradient_weight = 1e-4, gradient_scale = 0, hessian_weight = 0;
  std::string value_weight_property, gradient_weight_property, gradient_scale_property;
  CGAL::Gradient_domain_processing::Curvature_metric_kind metric =
    CGAL::Gradient_domain_processing::Curvature_metric_kind::EMBEDDING;
  CGAL::Gradient_domain_processing::Curvature_estimator curvature =
    CGAL::Gradient_domain_processing::Curvature_estimator::JETS;
  double curvature_weight = 0.02, presmoothing_weight = 1e-4, normal_projection_weight = 100;
  CGAL::Gradient_domain_processing::Normal_fit_kind normal_fit =
    CGAL::Gradient_domain_processing::Normal_fit_kind::FACES;
  int jet_degree = 2, iterations = 1, threads = 0;
  int non_shrinking = 1; // how often the filter is applied to what it has missed
  double sharpening_weight = 1e-5, sharpening_scale = 4;
  std::optional<int> passes;
  std::optional<double> noise_level, noise_scale, denoising_value_weight, max_displacement;
  CGAL::Gradient_domain_processing::Border_condition border = CGAL::Gradient_domain_processing::Border_condition::FREE;
  CGAL::Gradient_domain_processing::Border_condition non_manifold =
    CGAL::Gradient_domain_processing::Border_condition::FREE;
  bool restores_volume = false, area_normalization = true, has_missing_values = false, keeps_normals = false;
  std::array<bool, 3> moves_along = {{true, true, true}};
  std::optional<double> weld_tolerance = 0.; // none: seams stay open
  std::string constrained_property, region_property, region_vertices_property;
  std::vector<double> wavelengths; // one or two
  int filter_order = 4, number_of_harmonics = 10, filter_degree = 40;
  std::optional<CGAL::Gradient_domain_processing::Spectral_window> window; // none: Butterworth's filters
  std::optional<double> spectral_shift;                                    // none: the lowest harmonics
  std::string eigenvalues;

  Solver_kind solver = Solver_kind::AUTO;
  bool is_verbose = false, is_quiet = false;

  bool is_band() const
  {
    return operation == Operation::LOW_PASS || operation == Operation::HIGH_PASS || operation == Operation::BAND_PASS
        || operation == Operation::BAND_STOP;
  }
  bool moves_vertices() const
  {
    return operation != Operation::SPECTRUM
           && (signal == Signal_kind::POSITION || signal == Signal_kind::NORMAL_TO_POSITION);
  }
  bool is_of_paper() const { return operation == Operation::FILTER || operation == Operation::ENHANCE_DETAILS; }
  // Nothing is filtered: something is added to the file.
  bool only_adds() const { return operation == Operation::SPECTRUM || signal == Signal_kind::CURVATURE; }
  // Missing values are coordinates along the one axis along which vertices move.
  bool fills_heights() const
  {
    return has_missing_values && signal == Signal_kind::POSITION
           && std::count(moves_along.begin(), moves_along.end(), true) == 1;
  }
  bool has_metric() const { return metric != CGAL::Gradient_domain_processing::Curvature_metric_kind::EMBEDDING; }

  // For messages.
  std::string input_name() const { return input == "-" ? "standard input" : input; }
  std::string output_name() const { return output == "-" ? "standard output" : output; }

  // The options as words, for the summary and the report.
  std::string operation_name, signal_name, metric_name;

  std::string picture; // of before and after
};

// Throws Usage_error. False if there is nothing to do, as help or version were printed.
bool parse_command_line(int argc, char* argv[], Options& options);

// Whether the output can hold what is asked for; it may be known after reading only. Throws Usage_error.
void check_output_form(const Options& options, const Output_form& form);

#endif // GRADIENT_DOMAIN_FILTER_OPTIONS_H
