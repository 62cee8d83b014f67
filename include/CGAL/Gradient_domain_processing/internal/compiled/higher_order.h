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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_HIGHER_ORDER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_HIGHER_ORDER_H

#include <CGAL/Gradient_domain_processing/internal/higher_order/bilaplacian_impl.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/constrained_minimum_impl.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/curved_hessian_impl.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/fair_patch_impl.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/hessian_energy_impl.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/modified_dirichlet_impl.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/shell_hessian_impl.h>

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_HIGHER_ORDER_H
