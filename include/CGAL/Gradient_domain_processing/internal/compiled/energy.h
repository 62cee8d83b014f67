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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_ENERGY_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_ENERGY_H

#include <CGAL/Gradient_domain_processing/internal/energy/assemble_impl.h>
#include <CGAL/Gradient_domain_processing/internal/energy/floating_components_impl.h>
#include <CGAL/Gradient_domain_processing/internal/energy/prolongation_impl.h>
#include <CGAL/Gradient_domain_processing/internal/energy/recenter_impl.h>
#include <CGAL/Gradient_domain_processing/internal/energy/right_hand_side_impl.h>
#include <CGAL/Gradient_domain_processing/internal/energy/second_order_impl.h>
#include <CGAL/Gradient_domain_processing/internal/energy/sparsity_pattern_impl.h>

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_ENERGY_H
