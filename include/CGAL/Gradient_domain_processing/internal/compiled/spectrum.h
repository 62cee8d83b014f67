// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_SPECTRUM_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_SPECTRUM_H

#include <CGAL/Gradient_domain_processing/internal/spectrum/Spectral_system_impl.h>

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_SPECTRUM_H
