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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_MOVE_POSITIONS_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_MOVE_POSITIONS_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/filtering/move_positions.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE int limit_displacements(const std::vector<Vec3>& before, double limit, Indexed_triangles& mesh)
{
  int count = 0;
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    const Vec3 move = mesh.points[v] - before[v];
    const double length = move.norm();
    if(length <= limit)
      continue;
    mesh.points[v] = before[v] + limit / length * move;
    count += v < mesh.first_virtual_vertex();
  }
  return count;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_MOVE_POSITIONS_IMPL_H
