// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_WHY_UNCHANGED_H
#define GRADIENT_DOMAIN_FILTER_WHY_UNCHANGED_H

#include "Options.h"
#include "files/Mesh_file.h"

#include <string>
#include <vector>

// The reason, as far as it can be seen from outside of the filter. `signal` is what was to be filtered, by its columns.
std::string why_unchanged(const Options& options, const Mesh_file& file,
                          const std::vector<std::vector<double> >& signal);

#endif // GRADIENT_DOMAIN_FILTER_WHY_UNCHANGED_H
