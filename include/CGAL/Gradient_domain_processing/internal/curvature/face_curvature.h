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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_FACE_CURVATURE_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_FACE_CURVATURE_H

#include <CGAL/Gradient_domain_processing/internal/curvature/tangent_frame.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Curvatures of a triangle from those of its corners: the mean of the three tensors k1 d1 d1^T + k2 d2 d2^T, projected
// to the triangle's plane. Means of angles would not know that d and -d are the same direction.
// A triangle without a height has no plane to project to and is flat.
inline Principal_curvatures triangle_curvatures(const Vec3& p0, const Vec3& p1, const Vec3& p2,
                                                const Principal_curvatures& c0, const Principal_curvatures& c1,
                                                const Principal_curvatures& c2)
{
  const Planar_triangle t = planar_triangle(p0, p1, p2);
  if(t.is_degenerate)
    return flat_curvatures(t.frame);

  double a = 0, b = 0, c = 0;
  const auto add = [&](double curvature, const Vec3& direction)
  {
    const double x = direction.dot(t.frame.e1);
    const double y = direction.dot(t.frame.e2);
    a += curvature / 3 * x * x;
    b += curvature / 3 * x * y;
    c += curvature / 3 * y * y;
  };
  for(const Principal_curvatures* corner : { &c0, &c1, &c2 })
  {
    add(corner->min_curvature, corner->min_direction);
    add(corner->max_curvature, corner->max_direction);
  }
  return diagonalize(a, b, c, t.frame);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_FACE_CURVATURE_H
