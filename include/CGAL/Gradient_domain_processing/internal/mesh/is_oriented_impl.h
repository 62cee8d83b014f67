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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_IS_ORIENTED_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_IS_ORIENTED_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/mesh/is_oriented.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/connected_components.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE bool is_oriented(const Indexed_triangles& mesh)
{
  struct Sums
  {
    Vec3 area_vector = Vec3::Zero();
    double area = 0;
  };
  const Components components = connected_components(mesh);
  std::vector<Sums> sums(std::size_t(components.count));
  for(int f = 0; f < mesh.number_of_triangles(); ++f)
  {
    const Vec3 area_vector = mesh.area_vector(f);
    Sums& s = sums[std::size_t(components.of_vertex[std::size_t(mesh.triangles[std::size_t(f)][0])])];
    s.area_vector += area_vector;
    s.area += area_vector.norm();
  }
  return std::all_of(sums.begin(), sums.end(), [](const Sums& s) { return s.area_vector.norm() <= 1e-6 * s.area; });
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_IS_ORIENTED_IMPL_H
