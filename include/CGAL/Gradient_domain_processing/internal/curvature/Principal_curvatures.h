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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_PRINCIPAL_CURVATURES_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_PRINCIPAL_CURVATURES_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Curvatures are 1/length, positive where the surface is convex with respect to its outward normal, and
// min_curvature <= max_curvature. The directions are orthonormal.
struct Principal_curvatures
{
  double min_curvature, max_curvature;
  Vec3 min_direction, max_direction;
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_PRINCIPAL_CURVATURES_H
