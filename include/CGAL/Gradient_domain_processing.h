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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_H

#include <CGAL/license/Gradient_domain_processing.h>

/// \file Gradient_domain_processing.h
/// Includes all of the package.

#include <CGAL/Gradient_domain_processing/Automatic_sparse_linear_solver.h>
#include <CGAL/Gradient_domain_processing/curvature_metric.h>
#include <CGAL/Gradient_domain_processing/deformation_matrices.h>
#include <CGAL/Gradient_domain_processing/denoise.h>
#include <CGAL/Gradient_domain_processing/embedding_metric.h>
#include <CGAL/Gradient_domain_processing/enhance_details.h>
#include <CGAL/Gradient_domain_processing/estimate_curvatures.h>
#include <CGAL/Gradient_domain_processing/fair.h>
#include <CGAL/Gradient_domain_processing/filter_spectrum.h>
#include <CGAL/Gradient_domain_processing/fit_to_gradients.h>
#include <CGAL/Gradient_domain_processing/fit_to_normals.h>
#include <CGAL/Gradient_domain_processing/hessian_matrix.h>
#include <CGAL/Gradient_domain_processing/operators.h>
#include <CGAL/Gradient_domain_processing/process_face_signal.h>
#include <CGAL/Gradient_domain_processing/process_signal.h>
#include <CGAL/Gradient_domain_processing/sharpen.h>
#include <CGAL/Gradient_domain_processing/smooth.h>
#include <CGAL/Gradient_domain_processing/spectrum.h>
#include <CGAL/Gradient_domain_processing/stitch.h>

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_H
