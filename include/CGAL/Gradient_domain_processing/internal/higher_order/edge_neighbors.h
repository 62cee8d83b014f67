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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_EDGE_NEIGHBORS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_EDGE_NEIGHBORS_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_for.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// For every corner, the corner that faces it across the opposite edge, where exactly two triangles share that edge, in
// whichever orientation; -1 on a border and where three or more meet: there, none of them goes on into another
// smoothly.
inline std::vector<int> edge_neighbors(const Indexed_triangles& mesh, bool parallel)
{
  std::vector<int> neighbors(3 * mesh.triangles.size());
  parallel_for(parallel, neighbors.size(), [&](std::size_t corner) {
    const std::array<int, 2> ends = mesh.opposite_vertices(int(corner));
    int count = 0, found = -1;
    for(const int* c = mesh.corners.begin(ends[0]); c != mesh.corners.end(ends[0]); ++c)
    {
      const std::array<int, 2> others = mesh.opposite_vertices(*c);
      const int f = *c / 3, i = *c % 3;
      if(f == int(corner) / 3)
        continue;
      if(others[0] == ends[1])
      {
        ++count;
        found = 3 * f + (i + 2) % 3;
      }
      else if(others[1] == ends[1])
      {
        ++count;
        found = 3 * f + (i + 1) % 3;
      }
    }
    neighbors[corner] = count == 1 ? found : -1;
  });
  return neighbors;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_EDGE_NEIGHBORS_H
