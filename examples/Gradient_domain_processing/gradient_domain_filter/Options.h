// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_OPTIONS_H
#define GRADIENT_DOMAIN_FILTER_OPTIONS_H

#include "Mesh_file.h"

#include <CGAL/Gradient_domain_processing/enum.h>

#include <string>

enum class Operation { FILTER, ENHANCE_DETAILS, DENOISE };
enum class Signal_kind { POSITION, NORMAL, COLOR, NORMAL_TO_POSITION, CURVATURE };
enum class Solver_kind { AUTO, EIGEN, CHOLMOD, CG };

// The command line.
struct Options
{
  std::string input, output, report;
  File_format output_format = File_format::PLY;
  Encoding encoding = Encoding::DEFAULT;
  Read_options read;

  Operation operation = Operation::FILTER;
  Signal_kind signal = Signal_kind::POSITION;
  double value_weight = 1, gradient_weight = 1e-4, gradient_scale = 0;
  std::string value_weight_property, gradient_weight_property, gradient_scale_property;
  CGAL::Gradient_domain_processing::Curvature_metric_kind metric =
    CGAL::Gradient_domain_processing::Curvature_metric_kind::EMBEDDING;
  CGAL::Gradient_domain_processing::Curvature_estimator curvature = CGAL::Gradient_domain_processing::Curvature_estimator::JETS;
  double curvature_weight = 0.02, presmoothing_weight = 1e-4, normal_projection_weight = 100;
  int jet_degree = 2, iterations = 1, passes = 0, threads = 0;
  double sharpening_weight = 1e-5, sharpening_scale = 4;
  CGAL::Gradient_domain_processing::Border_condition border = CGAL::Gradient_domain_processing::Border_condition::FREE;
  bool restores_volume = false, area_normalization = true;
  std::string constrained_property, region_property;

  Solver_kind solver = Solver_kind::AUTO;
  bool is_verbose = false, is_quiet = false;

  bool has_masks() const
  {
    return !value_weight_property.empty() || !gradient_weight_property.empty() || !gradient_scale_property.empty();
  }
  bool moves_vertices() const { return signal == Signal_kind::POSITION || signal == Signal_kind::NORMAL_TO_POSITION; }

  // The options as words, for the summary and the report.
  std::string operation_name, signal_name, metric_name;
};

// Throws Usage_error. False if there is nothing to do, as help or version were printed.
bool parse_command_line(int argc, char* argv[], Options& options);

#endif // GRADIENT_DOMAIN_FILTER_OPTIONS_H
