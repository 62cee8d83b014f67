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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_PROLONGATION_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_PROLONGATION_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/energy/prolongation.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE Degrees_of_freedom with_virtual_vertices(const Degrees_of_freedom& dofs, const Indexed_triangles& mesh)
{
  std::vector<int> order = dofs.vertex;
  for(int v = mesh.first_virtual_vertex(); v < mesh.number_of_vertices(); ++v)
    order.push_back(v);
  return numbered(order, mesh.points.size());
}

CGAL_GDP_INLINE Sparse_matrix prolongation(const Degrees_of_freedom& dofs, const Indexed_triangles& mesh)
{
  const Virtual_vertices& virtual_vertices = mesh.virtual_vertices;
  std::vector<Eigen::Triplet<double> > entries;
  for(int i = 0; i < dofs.size(); ++i)
    entries.emplace_back(i, i, 1.);
  for(int k = 0; k < virtual_vertices.size(); ++k)
    for(int at = virtual_vertices.corners.offsets[k]; at < virtual_vertices.corners.offsets[k + 1]; ++at)
    {
      const int dof = dofs.of_vertex[mesh.vertex_of(virtual_vertices.corners.items[at])];
      if(dof >= 0)
        entries.emplace_back(dofs.size() + k, dof, virtual_vertices.weights[at]);
    }
  Sparse_matrix p(dofs.size() + virtual_vertices.size(), dofs.size());
  p.setFromTriplets(entries.begin(), entries.end());
  return p;
}

CGAL_GDP_INLINE void interpolate_virtual_vertices(const Indexed_triangles& mesh, Signal& displacement)
{
  const Virtual_vertices& virtual_vertices = mesh.virtual_vertices;
  for(int k = 0; k < virtual_vertices.size(); ++k)
  {
    auto row = displacement.row(mesh.first_virtual_vertex() + k);
    row.setZero();
    for(int at = virtual_vertices.corners.offsets[k]; at < virtual_vertices.corners.offsets[k + 1]; ++at)
      row += virtual_vertices.weights[at] * displacement.row(mesh.vertex_of(virtual_vertices.corners.items[at]));
  }
}

CGAL_GDP_INLINE Lists rings_of_polygons(const Lists& rings, const Indexed_triangles& mesh)
{
  const int first = mesh.first_virtual_vertex();
  Lists result;
  result.offsets.push_back(0);
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    const std::size_t begin = result.items.size();
    for(const int* w = rings.begin(v); w != rings.end(v) && v < first; ++w)
      if(*w < first)
        result.items.push_back(*w);
      else
        for(const int* row = mesh.virtual_vertices.corners.begin(*w - first);
            row != mesh.virtual_vertices.corners.end(*w - first); ++row)
          result.items.push_back(mesh.vertex_of(*row));
    std::sort(result.items.begin() + begin, result.items.end());
    result.items.erase(std::unique(result.items.begin() + begin, result.items.end()), result.items.end());
    result.items.erase(std::remove(result.items.begin() + begin, result.items.end(), v), result.items.end());
    result.offsets.push_back(int(result.items.size()));
  }
  return result;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_PROLONGATION_IMPL_H
