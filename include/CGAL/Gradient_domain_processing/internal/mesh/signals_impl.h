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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_SIGNALS_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_SIGNALS_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/mesh/signals.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE Signal mean_by_vertex(const Indexed_triangles& mesh, const Signal& signal)
{
  if(mesh.vertex_of_row.empty())
    return signal;
  Signal means = Signal::Zero(mesh.number_of_vertices(), signal.cols());
  std::vector<int> counts(mesh.points.size(), 0);
  for(int row = 0; row < mesh.number_of_rows(); ++row)
  {
    means.row(mesh.vertex_of(row)) += signal.row(row);
    ++counts[std::size_t(mesh.vertex_of(row))];
  }
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    means.row(v) /= counts[std::size_t(v)];
  return means;
}

CGAL_GDP_INLINE std::vector<Vec3> mean_over_rows(const Indexed_triangles& mesh, const Signal& vectors)
{
  return as_vectors(mean_by_vertex(mesh, vectors));
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_SIGNALS_IMPL_H
