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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_NORMAL_CURVATURE_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_NORMAL_CURVATURE_H

#include <CGAL/Gradient_domain_processing/internal/curvature/tangent_frame.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Curvatures of a triangle from the change of the unit normals at its corners: the symmetric part of the derivative of
// the normal, which is II_ij = (t_i . dn_j + t_j . dn_i) / 2 seen from an orthonormal frame in place of two sides t_1,
// t_2. A triangle without a height is flat.
inline Principal_curvatures triangle_curvatures(const Vec3& p0, const Vec3& p1, const Vec3& p2,
                                                const Vec3& n0, const Vec3& n1, const Vec3& n2)
{
  const Planar_triangle t = planar_triangle(p0, p1, p2);
  if(t.is_degenerate)
    return flat_curvatures(t.frame);

  const Vec3* normals[3] = { &n0, &n1, &n2 };
  const Vec3& origin = *normals[t.first];
  const Vec3 along = *normals[(t.first + 1) % 3] - origin;
  const Vec3 up = (*normals[(t.first + 2) % 3] - origin) - (t.x / t.length) * along;

  const Vec3 dn1 = along / t.length;
  const Vec3 dn2 = up / t.height;
  return diagonalize(t.frame.e1.dot(dn1),
                     t.frame.e1.dot(dn2) / 2 + t.frame.e2.dot(dn1) / 2,
                     t.frame.e2.dot(dn2), t.frame);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_NORMAL_CURVATURE_H
