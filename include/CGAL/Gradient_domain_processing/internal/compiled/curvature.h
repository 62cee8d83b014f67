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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_CURVATURE_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_CURVATURE_H

#include <CGAL/Gradient_domain_processing/internal/curvature/estimates_impl.h>
#include <CGAL/Gradient_domain_processing/internal/metric/curvature_metric_impl.h>

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_COMPILED_CURVATURE_H
