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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_RESTORE_VOLUMES_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_RESTORE_VOLUMES_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/mesh/restore_volumes.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/connected_components.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <cmath>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE bool restore_volumes(const Indexed_triangles& mesh, const std::vector<Vec3>& before,
                                     std::vector<Vec3>& after)
{
  const Components components = connected_components(mesh);
  struct Sums
  {
    double volume_before = 0, volume_after = 0, area_before = 0, area = 0;
    Vec3 moment = Vec3::Zero(), origin = Vec3::Zero();
    bool has_origin = false;

    bool has_volume() const { return std::abs(volume_before) > 1e-9 * std::pow(area_before, 1.5); }
    double ratio() const { return volume_before / volume_after; }
  };
  std::vector<Sums> sums(components.count);
  for(const auto& t : mesh.triangles)
  {
    Sums& s = sums[components.of_vertex[t[0]]];
    if(!s.has_origin)
    {
      s.origin = before[t[0]];
      s.has_origin = true;
    }
    const auto volume = [&](const std::vector<Vec3>& p) {
      const Vec3 a = p[t[0]] - s.origin, b = p[t[1]] - s.origin, c = p[t[2]] - s.origin;
      return a.dot(b.cross(c)) / 6;
    };
    s.volume_before += volume(before);
    s.volume_after += volume(after);
    s.area_before += (before[t[1]] - before[t[0]]).cross(before[t[2]] - before[t[0]]).norm() / 2;
    const Vec3 &a = after[t[0]], &b = after[t[1]], &c = after[t[2]];
    const double area = (b - a).cross(c - a).norm() / 2;
    s.area += area;
    s.moment += area / 3 * ((a - s.origin) + (b - s.origin) + (c - s.origin));
  }
  for(const Sums& s : sums)
    if(s.has_volume() && !(s.ratio() > 0 && std::isfinite(s.ratio()) && s.area > 0))
      return false;
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    const Sums& s = sums[components.of_vertex[v]];
    if(!s.has_volume() || s.ratio() == 1)
      continue;
    const Vec3 centroid = s.origin + s.moment / s.area;
    after[v] = centroid + std::cbrt(s.ratio()) * (after[v] - centroid);
  }
  return true;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_RESTORE_VOLUMES_IMPL_H
