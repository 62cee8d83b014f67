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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_ASSEMBLE_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_ASSEMBLE_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/energy/assemble.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>
#include <atomic>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE bool assemble(const Indexed_triangles& mesh, const Triangle_metrics& metrics,
                              const Energy_weights& weights, const Degrees_of_freedom& dofs, bool parallel,
                              Sparse_matrix& matrix, bool is_system)
{
  std::atomic<bool> values_weigh_little(false);
  const int* const offsets = matrix.outerIndexPtr();
  const int* const rows = matrix.innerIndexPtr();
  double* const values = matrix.valuePtr();
  for_each_degree_of_freedom(parallel, dofs, mesh, metrics, [&](int v, int j, const Block_coefficients& coefficients) {
    const int first = offsets[j], last = offsets[j + 1];
    std::fill(values + first, values + last, 0.);
    double sum = 0, diagonal = 0;
    const auto add = [&](int row, double value) {
      if(row >= 0)
        sum += value;
      for(int at = first; at < last; ++at) // not found: in the other triangle of the matrix, or constrained
        if(rows[at] == row)
        {
          values[at] += value;
          return;
        }
    };
    for(const int* c = mesh.corners.begin(v); c != mesh.corners.end(v); ++c)
    {
      const Row_entries entries = row_entries(mesh, coefficients(*c / 3), weights, *c);
      const auto others = mesh.opposite_vertices(*c);
      diagonal += entries.vv;
      add(dofs.of_vertex[others[0]], entries.va);
      add(dofs.of_vertex[others[1]], entries.vb);
    }
    // in a system to be solved, a vertex that nothing acts on stays where it is
    add(j, is_system && diagonal == 0 ? 1. : diagonal);
    if(sum < 1e-9 * diagonal)
      values_weigh_little.store(true, std::memory_order_relaxed);
  });
  return values_weigh_little;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_ASSEMBLE_IMPL_H
