// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_REPORT_H
#define GRADIENT_DOMAIN_FILTER_REPORT_H

#include "Mesh_file.h"
#include "Options.h"
#include "Stage_clock.h"
#include "filter_mesh.h"

#include <string>
#include <vector>

// What was done, for people and for programs.
struct Report
{
  std::size_t vertices = 0, edges = 0, faces = 0, border_edges = 0;
  double area = 0;
  double max_displacement = 0, mean_displacement = 0; // of the signal, in its own units
  Solver_facts solver;

  void count(const Mesh& mesh);
  std::string json(const Options& options, const Stage_clock& clock) const;
  std::string summary(const Options& options, const Stage_clock& clock, const std::vector<std::string>& notes) const;
};

#endif // GRADIENT_DOMAIN_FILTER_REPORT_H
