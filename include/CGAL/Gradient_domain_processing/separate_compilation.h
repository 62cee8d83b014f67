// Copyright (c) 2026  The Gradient_domain_processing authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Gradient_domain_processing authors

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_SEPARATE_COMPILATION_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_SEPARATE_COMPILATION_H

#include <CGAL/license/Gradient_domain_processing.h>

/// \file separate_compilation.h
/// All that is not a template. Where `CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED` is defined for all files of a program,
/// one of them includes this; the others compile faster. (With CMake, the target
/// `CGAL::Gradient_domain_processing_compiled` does both.)

#include <CGAL/Gradient_domain_processing/internal/compiled/curvature.h>
#include <CGAL/Gradient_domain_processing/internal/compiled/energy.h>
#include <CGAL/Gradient_domain_processing/internal/compiled/filtering.h>
#include <CGAL/Gradient_domain_processing/internal/compiled/higher_order.h>
#include <CGAL/Gradient_domain_processing/internal/compiled/linear_solver.h>
#include <CGAL/Gradient_domain_processing/internal/compiled/mesh.h>
#include <CGAL/Gradient_domain_processing/internal/compiled/ordering.h>
#include <CGAL/Gradient_domain_processing/internal/compiled/spectrum.h>

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_SEPARATE_COMPILATION_H
