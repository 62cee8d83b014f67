// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_FILTER_MESH_H
#define GRADIENT_DOMAIN_FILTER_FILTER_MESH_H

#include "Options.h"
#include "Stage_clock.h"

#include <CGAL/Gradient_domain_processing/Error_code.h>

#include <string>
#include <utility>
#include <vector>

// What a filter tells of itself; negative where it does not.
struct Filter_facts
{
  std::string solver;
  double matrix_non_zeros = -1, factor_non_zeros = -1, iterations = -1;
  std::vector<std::pair<std::string, double> > found; // that the filter chose from the data
  std::string why_unchanged;                          // that only the filter knows
  std::vector<double> eigenvalues;
};

// Does what the options ask for to the points or the columns of the file. Throws Failure if a property is missing.
CGAL::Gradient_domain_processing::Error_code filter_mesh(const Options&, Mesh_file&, Stage_clock&, Filter_facts&);

// Parts of it. With a linear solver each, for every one is a compilation of the whole package; and those that need
// none.
CGAL::Gradient_domain_processing::Error_code filter_with_default(const Options&, Mesh_file&, Stage_clock&,
                                                                 Filter_facts&);
CGAL::Gradient_domain_processing::Error_code filter_with_eigen(const Options&, Mesh_file&, Stage_clock&, Filter_facts&);
CGAL::Gradient_domain_processing::Error_code filter_with_cg(const Options&, Mesh_file&, Stage_clock&, Filter_facts&);
CGAL::Gradient_domain_processing::Error_code denoise_mesh(const Options&, Mesh_file&, Stage_clock&, Filter_facts&);
CGAL::Gradient_domain_processing::Error_code fair_mesh(const Options&, Mesh_file&, Stage_clock&, Filter_facts&);
CGAL::Gradient_domain_processing::Error_code filter_bands(const Options&, Mesh_file&, Stage_clock&, Filter_facts&);
CGAL::Gradient_domain_processing::Error_code write_spectrum(const Options&, Mesh_file&, Stage_clock&, Filter_facts&);
CGAL::Gradient_domain_processing::Error_code filter_face_properties(const Options&, Mesh_file&, Stage_clock&,
                                                                    Filter_facts&);

// NaN among the coordinates along the one axis becomes a height between those around it.
CGAL::Gradient_domain_processing::Error_code fill_missing_heights(const Options&, Mesh_file&, Stage_clock&);

#endif // GRADIENT_DOMAIN_FILTER_FILTER_MESH_H
