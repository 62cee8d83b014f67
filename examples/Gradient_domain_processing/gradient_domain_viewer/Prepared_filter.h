// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_VIEWER_PREPARED_FILTER_H
#define GRADIENT_DOMAIN_VIEWER_PREPARED_FILTER_H

#include "Stage_clock.h"
#include "files/Mesh_file.h"

#include <CGAL/Gradient_domain_processing/Error_code.h>

#include <memory>
#include <string>
#include <vector>

struct Filter_settings;
struct Options;

// The solver of one mesh with its regions and constraints, and what it was last asked for.
class Prepared_filter
{
  struct Solver;
  std::unique_ptr<Solver> m_solver;

public:
  Prepared_filter(const Options& options, Mesh_file file);
  ~Prepared_filter();

  // The points for lambda = 0, if they are other ones than those of the last settings.
  CGAL::Gradient_domain_processing::Error_code set(const Filter_settings& settings, std::vector<Point>& smoothed);

  int number_of_solutions() const;
  const std::string& why_unchanged() const; // empty if anything may have
  const Stage_clock& clock() const;
};

#endif // GRADIENT_DOMAIN_VIEWER_PREPARED_FILTER_H
