// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_CHOOSE_SOLVER_H
#define GRADIENT_DOMAIN_FILTER_CHOOSE_SOLVER_H

#include "Options.h"

// Whether, where the choice is ours, conjugate gradients are expected to be the faster solver, or the only one that
// fits into memory.
bool prefers_conjugate_gradients(const Options& options, const Mesh_file& file);

#endif // GRADIENT_DOMAIN_FILTER_CHOOSE_SOLVER_H
