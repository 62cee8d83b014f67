// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_ORDERING_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_ORDERING_H

#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/elimination_order_impl.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/nested_dissection_impl.h>

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_ORDERING_H
