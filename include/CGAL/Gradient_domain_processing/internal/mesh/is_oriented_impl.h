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
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Every edge is gone along as often in one direction as in the other.
CGAL_GDP_INLINE bool is_oriented(const Indexed_triangles& mesh)
{
  std::vector<int> balance(mesh.points.size(), 0); // at the other ends of a vertex's edges
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    const auto for_each_edge = [&](const auto& visit) {
      for(const int* corner = mesh.corners.begin(v); corner != mesh.corners.end(v); ++corner)
      {
        const auto& t = mesh.triangles[std::size_t(*corner / 3)];
        const std::size_t i = std::size_t(*corner % 3);
        visit(std::size_t(t[(i + 1) % 3]), 1);
        visit(std::size_t(t[(i + 2) % 3]), -1);
      }
    };
    bool is_even = true;
    for_each_edge([&](std::size_t end, int direction) { balance[end] += direction; });
    for_each_edge([&](std::size_t end, int) { is_even = is_even && std::exchange(balance[end], 0) == 0; });
    if(!is_even)
      return false;
  }
  return true;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_IS_ORIENTED_IMPL_H
