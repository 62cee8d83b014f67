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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_OPERATORS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_OPERATORS_H

#include <CGAL/license/Gradient_domain_processing.h>

/// \file operators.h
/// The matrices of the energy (paper, appendix A), for energies of your own.

#include <CGAL/Gradient_domain_processing/divergence_matrix.h>
#include <CGAL/Gradient_domain_processing/gradient_matrix.h>
#include <CGAL/Gradient_domain_processing/mass_matrix.h>
#include <CGAL/Gradient_domain_processing/stiffness_matrix.h>

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_OPERATORS_H
