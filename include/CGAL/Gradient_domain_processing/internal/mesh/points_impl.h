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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_POINTS_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_POINTS_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/mesh/points.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE void normalize_extent(Indexed_triangles& mesh)
{
  if(mesh.points.empty())
    return;
  Vec3 low = mesh.points[0], high = mesh.points[0];
  for(const Vec3& p : mesh.points)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double extent = (high - low).maxCoeff();
  if(!(extent > 0))
    return;
  const int before = mesh.exponent;
  int power;
  std::frexp(extent, &power);
  mesh.exponent = (std::max)(before + power, -500); // lest the factor overflow
  const double factor = std::ldexp(1., before - mesh.exponent);
  for(Vec3& p : mesh.points)
    p *= factor;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_POINTS_IMPL_H
