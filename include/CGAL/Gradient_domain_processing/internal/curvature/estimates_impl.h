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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_ESTIMATES_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_ESTIMATES_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/curvature/estimates.h>
#include <CGAL/Gradient_domain_processing/internal/curvature/face_curvature.h>
#include <CGAL/Gradient_domain_processing/internal/curvature/jet_curvature.h>
#include <CGAL/Gradient_domain_processing/internal/curvature/normal_curvature.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_for.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <cstddef>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

template <class Void>
bool vertex_curvatures_by_jets(const Indexed_triangles& mesh, const std::vector<Vec3>& points,
                               const std::vector<Vec3>& normals, int jet_degree, bool parallel,
                               const std::function<bool(double)>& go_on, std::vector<Principal_curvatures>& curvatures)
{
  const Lists rings = mesh.one_rings(parallel);
  return jet_curvatures(parallel, points, rings.offsets, rings.items, normals, jet_degree, go_on, curvatures);
}

CGAL_GDP_INLINE std::vector<Principal_curvatures> triangle_curvatures(
  const Indexed_triangles& mesh, bool parallel, const std::vector<Principal_curvatures>& at_vertices)
{
  std::vector<Principal_curvatures> curvatures(mesh.triangles.size());
  parallel_for(parallel, curvatures.size(), [&](std::size_t f) {
    const auto& t = mesh.triangles[f];
    curvatures[f] = triangle_curvatures(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]],
                                        at_vertices[t[0]], at_vertices[t[1]], at_vertices[t[2]]);
  });
  return curvatures;
}

CGAL_GDP_INLINE std::vector<Principal_curvatures> triangle_curvatures_by_normals(const Indexed_triangles& mesh,
                                                                                 bool parallel,
                                                                                 std::vector<Vec3> normals)
{
  parallel_for(parallel, normals.size(), [&](std::size_t v) {
    const double length = normals[v].norm();
    if(length > 0)
      normals[v] /= length;
  });
  std::vector<Principal_curvatures> curvatures(mesh.triangles.size());
  parallel_for(parallel, curvatures.size(), [&](std::size_t f) {
    const auto& t = mesh.triangles[f];
    curvatures[f] = triangle_curvatures(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]],
                                        normals[t[0]], normals[t[1]], normals[t[2]]);
  });
  return curvatures;
}

#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
template bool vertex_curvatures_by_jets<>(const Indexed_triangles& mesh, const std::vector<Vec3>& points,
                                          const std::vector<Vec3>& normals, int jet_degree, bool parallel,
                                          const std::function<bool(double)>& go_on,
                                          std::vector<Principal_curvatures>& curvatures);
#endif

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_ESTIMATES_IMPL_H
