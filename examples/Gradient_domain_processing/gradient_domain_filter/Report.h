// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_REPORT_H
#define GRADIENT_DOMAIN_FILTER_REPORT_H

#include "Options.h"
#include "Stage_clock.h"
#include "Survey.h"
#include "filter_mesh.h"

#include <optional>
#include <string>
#include <vector>

// What was done, for people and for programs.
struct Report
{
  std::optional<Survey> survey;
  std::size_t changed_values = 0;                     // of the signal: vertices, normals or faces
  double max_displacement = 0, mean_displacement = 0; // of the signal, in its own units
  double extent_ratio = 1;                            // of what has changed, after and before
  std::string why_unchanged;                          // empty if anything changed but by rounding
  std::vector<double> displacement_of_part;           // the largest, where there are several
  std::vector<std::string> not_kept, notices;
  std::size_t updated_normals = 0;
  Filter_facts facts;

  // How far the signal moved, by its columns. Whether it moved by more than rounding.
  bool measure(const std::vector<std::vector<double> >& before, const std::vector<std::vector<double> >& after);

  // What a stranger may trip over, a line each; the library's notices are among them.
  std::vector<std::string> remarks(const Options& options) const;

  std::string json(const Options& options, const Stage_clock& clock) const;
  std::string summary(const Options& options, const Stage_clock& clock) const;
};

#endif // GRADIENT_DOMAIN_FILTER_REPORT_H
