// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_FAILURE_H
#define GRADIENT_DOMAIN_FILTER_FAILURE_H

#include <stdexcept>
#include <string>

// The work failed: exit code 1.
struct Failure : std::runtime_error
{
  using std::runtime_error::runtime_error;
  Failure(const std::string& file, const std::string& what) : std::runtime_error(file + ": " + what) {}
};

// The command line makes no sense: exit code 2.
struct Usage_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

#endif // GRADIENT_DOMAIN_FILTER_FAILURE_H
