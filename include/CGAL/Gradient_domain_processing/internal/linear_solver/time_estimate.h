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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_TIME_ESTIMATE_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_TIME_ESTIMATE_H

#include <CGAL/Gradient_domain_processing/internal/linear_solver/Solver_task.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/memory_estimate.h>

#include <cmath>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The times are seconds of one core of 2024, of which only ratios matter. Constants were set by the stages of a closed
// scan of 967 thousand vertices under the metric of the embedding on 1 to 16 threads of an idle machine, and looked at
// on one of 800 thousand with needles and on a torus of 10 million. The factor of a metric is a guess from a few runs.
inline double on_cores(double seconds, double share_of_one_core, unsigned cores)
{
  return seconds * (share_of_one_core + (1 - share_of_one_core) / double(cores));
}

// Down to 1e-10. A metric brings couplings of different strength, which cost iterations.
inline double multigrid_iterations(const Solver_task& task)
{
  // its argument: cells across a wave, squared
  const double iterations = 16 + 4 * std::log10(1 + task.gradient_weight * double(task.unknowns));
  return task.has_metric ? 1.5 * iterations : iterations;
}

inline double multigrid_time(const Solver_task& task)
{
  const double n = double(task.unknowns), quadruples = std::ceil(task.channels / 4.);
  return task.matrices
         * (on_cores(1.3e-6 * n, 0.15, task.cores)
            + task.solutions_of_each * quadruples
                * on_cores(8.6e-8 * n * multigrid_iterations(task), 0.07, task.cores));
}

inline double cholesky_time(const Solver_task& task)
{
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
  const double sparse = 1.6e-6, dense = 1.3e-9; // of large fronts
#else
  const double sparse = 2.5e-6, dense = 3.2e-8;
#endif
  const double n = double(task.unknowns);
  return on_cores(2.3e-6 * n, 0.33, task.cores)
         + task.matrices
             * (sparse * n + dense * n * std::sqrt(n) + task.solutions_of_each * task.channels * 1.2e-7 * n);
}

// Conjugate gradients with multigrid where Cholesky does not fit into memory, or where they save a fifth of the time
// and a tenth of a second: on small meshes the solution is exact.
inline bool multigrid_pays(const Solver_task& task, double memory = available_memory())
{
  if(!cholesky_fits(task.unknowns, memory))
    return true;
  if(task.is_of_second_order) // conditions are squared
    return false;
  const double saved = cholesky_time(task) - multigrid_time(task);
  return saved > 0.1 && saved > 0.2 * cholesky_time(task);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_TIME_ESTIMATE_H
