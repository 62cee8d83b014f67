// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_MPI_SURFACE_JOB_H
#define GRADIENT_DOMAIN_FILTER_MPI_SURFACE_JOB_H

#include "Ranks.h"

#include "../gradient_domain_filter/Options.h"

#include <string>
#include <vector>

// What was done, for the summary.
struct Job_report
{
  struct Stage
  {
    std::string name;
    double seconds;          // of the slowest rank
    std::int64_t sent_bytes; // of all ranks together, by the program itself
  };
  std::vector<Stage> stages;
  Global vertices = 0, faces = 0;
  int welded_vertices = 0, iterations = 0, systems = 0;
  std::string preconditioner;
};

// From the input to the output, on all ranks. Throws Failure.
Job_report filter_file(const Ranks& ranks, const Options& options);

#endif // GRADIENT_DOMAIN_FILTER_MPI_SURFACE_JOB_H
