// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "choose_solver.h"

#include <CGAL/Gradient_domain_processing/internal/linear_solver/time_estimate.h>

#include <algorithm>
#include <thread>

using CGAL::Gradient_domain_processing::internal::Solver_task;

namespace {

// Where it is not known, one that is large.
double relative_gradient_weight(const Options& options)
{
  const bool is_known =
    options.area_normalization && options.gradient_weight_property.empty() && options.value_weight_property.empty();
  const double weight =
    (is_known ? options.gradient_weight : (std::max)(options.gradient_weight, 1.)) / options.value_weight;
  return options.signal == Signal_kind::NORMAL_TO_POSITION ? (std::max)(weight, options.normal_projection_weight)
                                                           : weight;
}

int number_of_matrices(const Options& options)
{
  if(options.operation == Operation::ENHANCE_DETAILS)
    return 2;
  const bool is_presmoothed = options.has_metric() && options.presmoothing_weight > 0;
  return options.iterations * (1 + is_presmoothed + (options.signal == Signal_kind::NORMAL_TO_POSITION));
}

unsigned number_of_cores(const Options& options)
{
#ifdef CGAL_LINKED_WITH_TBB
  const unsigned all = (std::max)(std::thread::hardware_concurrency(), 1u);
  return options.threads > 0 ? (std::min)(unsigned(options.threads), all) : all;
#else
  (void)options;
  return 1;
#endif
}

} // namespace

bool prefers_conjugate_gradients(const Options& options, const Mesh_file& file)
{
  Solver_task task;
  task.unknowns = file.points.size();
  task.channels = options.signal == Signal_kind::PROPERTY ? int(options.signal_properties.size()) : 3;
  task.matrices = number_of_matrices(options);
  task.solutions_of_each = options.non_shrinking;
  task.gradient_weight = relative_gradient_weight(options);
  task.has_metric = options.has_metric();
  task.cores = number_of_cores(options);
  return CGAL::Gradient_domain_processing::internal::multigrid_pays(task);
}
