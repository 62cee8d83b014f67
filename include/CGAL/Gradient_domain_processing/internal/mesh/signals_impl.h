// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_SIGNALS_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_SIGNALS_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/mesh/signals.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE std::vector<Vec3> mean_over_rows(const Indexed_triangles& mesh, const Signal& vectors)
{
  if(mesh.vertex_of_row.empty())
    return as_vectors(vectors);
  std::vector<Vec3> sums(mesh.points.size(), Vec3(0, 0, 0));
  std::vector<int> counts(mesh.points.size(), 0);
  for(int row = 0; row < mesh.number_of_rows(); ++row)
  {
    sums[mesh.vertex_of(row)] += vectors.row(row).transpose();
    ++counts[mesh.vertex_of(row)];
  }
  for(std::size_t v = 0; v < sums.size(); ++v)
    sums[v] /= counts[v];
  return sums;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_SIGNALS_IMPL_H
