// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_MPI_SHARED_OPTIONS_H
#define GRADIENT_DOMAIN_FILTER_MPI_SHARED_OPTIONS_H

#include "../gradient_domain_filter/Options.h"

// The command line of gradient_domain_filter, as far as it makes sense here; the rest is refused. Throws Usage_error.
void check_shared_options(int argc, char* argv[], const Options& options);

extern const char* const shared_options_help;

#endif // GRADIENT_DOMAIN_FILTER_MPI_SHARED_OPTIONS_H
