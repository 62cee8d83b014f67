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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_FILTERING_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_FILTERING_H

#include <CGAL/Gradient_domain_processing/internal/filtering/Filter_impl.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/face_energy_impl.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/filter_positions_impl.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/filter_signal_impl.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/filter_spectrum_of_signal_impl.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/move_positions_impl.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/own_normals_impl.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/read_parameters_impl.h>

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_FILTERING_H
