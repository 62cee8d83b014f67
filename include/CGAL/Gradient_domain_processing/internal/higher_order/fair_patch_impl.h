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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_FAIR_PATCH_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_FAIR_PATCH_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/higher_order/fair_patch.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/constrained_minimum.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/hessian_energy.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/connected_components.h>
#include <CGAL/Gradient_domain_processing/internal/metric/Triangle_metrics.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The free vertices and what their energy depends on: three layers of triangles around them.
struct Patch
{
  Indexed_triangles mesh;
  std::vector<int> vertices; // of the patch in the mesh it was taken from
  std::vector<char> is_free;
};

CGAL_GDP_INLINE Patch patch_around(const Indexed_triangles& mesh, const std::vector<char>& is_free)
{
  std::vector<char> is_near = is_free, is_in(mesh.triangles.size(), 0);
  for(int layer = 0; layer < 3; ++layer)
  {
    for(std::size_t f = 0; f < is_in.size(); ++f)
      for(int v : mesh.triangles[f])
        is_in[f] = is_in[f] || is_near[std::size_t(v)];
    for(std::size_t f = 0; f < is_in.size(); ++f)
      for(int v : mesh.triangles[f])
        is_near[std::size_t(v)] = is_near[std::size_t(v)] || is_in[f];
  }

  Patch patch;
  std::vector<int> local(mesh.points.size(), -1);
  for(std::size_t v = 0; v < local.size(); ++v)
    if(is_near[v])
    {
      local[v] = int(patch.vertices.size());
      patch.vertices.push_back(int(v));
      patch.mesh.points.push_back(mesh.points[v]);
      patch.is_free.push_back(is_free[v]);
    }
  for(std::size_t f = 0; f < is_in.size(); ++f)
    if(is_in[f])
    {
      const auto& t = mesh.triangles[f];
      patch.mesh.triangles.push_back({{local[std::size_t(t[0])], local[std::size_t(t[1])], local[std::size_t(t[2])]}});
    }
  patch.mesh.index_corners();
  return patch;
}

// Whether every component with a free vertex that has triangles has constrained ones as well: three, for it could turn
// else.
CGAL_GDP_INLINE bool is_constrained_enough(const Patch& patch)
{
  const Components components = connected_components(patch.mesh);
  std::vector<int> constrained(std::size_t(components.count), 0);
  std::vector<char> is_moving(std::size_t(components.count), 0);
  for(std::size_t v = 0; v < patch.is_free.size(); ++v)
    if(!patch.is_free[v])
      ++constrained[std::size_t(components.of_vertex[v])];
    else if(patch.mesh.corners.size(int(v)) > 0)
      is_moving[std::size_t(components.of_vertex[v])] = 1;
  for(std::size_t c = 0; c < constrained.size(); ++c)
    if(is_moving[c] && constrained[c] < 3)
      return false;
  return true;
}

CGAL_GDP_INLINE Error_code fair_patch(Indexed_triangles& mesh, const std::vector<char>& is_free, Hessian_kind kind,
                                      int max_iterations, double tolerance, bool parallel)
{
  Patch patch = patch_around(mesh, is_free);
  for(std::size_t v = 0; v < patch.is_free.size(); ++v) // nothing acts on a vertex without triangles
    patch.is_free[v] = patch.is_free[v] && patch.mesh.corners.size(int(v)) > 0;
  if(!is_constrained_enough(patch))
    return error_unconstrained;

  std::vector<Vec3>& points = patch.mesh.points;
  Eigen::MatrixXd x(Eigen::Index(points.size()), 3);
  for(int iteration = 0; iteration < max_iterations; ++iteration)
  {
    for(std::size_t v = 0; v < points.size(); ++v)
      x.row(Eigen::Index(v)) = points[v].transpose();
    const Eigen::SparseMatrix<double> energy = hessian_energy(patch.mesh, Triangle_metrics(), kind, parallel);
    if(const Error_code code = constrained_minimum(energy, patch.is_free, x))
      return code;
    double largest_move = 0;
    Vec3 low = Vec3::Constant(HUGE_VAL), high = -low;
    for(std::size_t v = 0; v < points.size(); ++v)
      if(patch.is_free[v])
      {
        const Vec3 moved = x.row(Eigen::Index(v)).transpose();
        largest_move = (std::max)(largest_move, (moved - points[v]).norm());
        points[v] = moved;
        low = low.cwiseMin(moved);
        high = high.cwiseMax(moved);
      }
    if(!(largest_move > tolerance * (high - low).norm()))
      break;
  }
  for(std::size_t v = 0; v < points.size(); ++v)
    if(patch.is_free[v])
      mesh.points[std::size_t(patch.vertices[v])] = points[v];
  return ok;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_FAIR_PATCH_IMPL_H
