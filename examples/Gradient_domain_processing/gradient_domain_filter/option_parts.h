// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_OPTION_PARTS_H
#define GRADIENT_DOMAIN_FILTER_OPTION_PARTS_H

#include "Options.h"

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>

// All options but the files, with their texts; numbers and names go to `options`.
boost::program_options::options_description describe_options(Options& options);
void print_help(const boost::program_options::options_description& described);

// What contradicts what, and what is out of range. Throws Usage_error.
void check_options(const boost::program_options::variables_map& given, const Options& options);

bool is_given(const boost::program_options::variables_map& given, const std::string& option);

#endif // GRADIENT_DOMAIN_FILTER_OPTION_PARTS_H
