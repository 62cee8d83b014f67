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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_OFFSET_TO_VOLUMES_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_OFFSET_TO_VOLUMES_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/mesh/connected_components.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/offset_to_volumes.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The move of every vertex that moves the planes of its faces by one, in the mean: longer at creases.
inline std::vector<Vec3> unit_offsets(const Indexed_triangles& mesh, const std::vector<Vec3>& points, bool parallel)
{
  constexpr double least_cosine = 0.3; // at a spike
  std::vector<Vec3> offsets = mesh.vertex_normals(points, parallel);
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    double height = 0, area = 0;
    for(const int* c = mesh.corners.begin(v); c != mesh.corners.end(v); ++c)
    {
      const Vec3 normal = mesh.area_vector(*c / 3, points);
      height += normal.dot(offsets[std::size_t(v)]);
      area += normal.norm();
    }
    if(area > 0)
      offsets[std::size_t(v)] /= (std::max)(height / area, least_cosine);
  }
  // what is inside of a polygon follows its corners
  const Virtual_vertices& inside = mesh.virtual_vertices;
  for(int k = 0; k < inside.size(); ++k)
  {
    Vec3 mean = Vec3::Zero();
    for(int at = inside.corners.offsets[k]; at < inside.corners.offsets[k + 1]; ++at)
      mean += inside.weights[std::size_t(at)] * offsets[std::size_t(mesh.vertex_of(inside.corners.items[at]))];
    offsets[std::size_t(mesh.first_virtual_vertex() + k)] = mean;
  }
  return offsets;
}

CGAL_GDP_INLINE int offset_to_volumes(const Indexed_triangles& mesh, const std::vector<Vec3>& before, bool parallel,
                                      std::vector<Vec3>& after)
{
  struct Part
  {
    double wanted = 0, area = 0, length = 0, volume = 0, slope = 0; // `length` of the offset
    int origin = -1;
  };
  const Components components = connected_components(mesh);
  std::vector<Part> parts(std::size_t(components.count));
  const auto part_of = [&](int f) -> Part& {
    return parts[std::size_t(components.of_vertex[std::size_t(mesh.triangles[std::size_t(f)][0])])];
  };
  const auto volume = [&](int f, const std::vector<Vec3>& points) {
    const auto& t = mesh.triangles[std::size_t(f)];
    const Vec3& origin = before[std::size_t(part_of(f).origin)];
    return mesh.area_vector(f, points).dot(points[std::size_t(t[0])] - origin) / 6;
  };
  for(int f = 0; f < mesh.number_of_triangles(); ++f)
  {
    Part& part = part_of(f);
    if(part.origin < 0)
      part.origin = mesh.triangles[std::size_t(f)][0];
    part.wanted += volume(f, before);
    part.area += mesh.area_vector(f, before).norm() / 2;
  }

  const std::vector<Vec3> offsets = unit_offsets(mesh, after, parallel);
  std::vector<Vec3> moved = after;
  for(int step = 0; step < 8; ++step) // Newton's; the volume is cubic
  {
    for(Part& part : parts)
      part.volume = part.slope = 0;
    for(int f = 0; f < mesh.number_of_triangles(); ++f)
    {
      Part& part = part_of(f);
      part.volume += volume(f, moved);
      for(int v : mesh.triangles[std::size_t(f)])
        part.slope += mesh.area_vector(f, moved).dot(offsets[std::size_t(v)]) / 6;
    }
    for(Part& part : parts)
      if(std::abs(part.wanted - part.volume) > 1e-13 * std::abs(part.wanted))
        part.length += (part.wanted - part.volume) / part.slope;
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      moved[std::size_t(v)] =
        after[std::size_t(v)]
        + parts[std::size_t(components.of_vertex[std::size_t(v)])].length * offsets[std::size_t(v)];
  }

  const auto has_volume = [](const Part& part) { return std::abs(part.wanted) > 1e-9 * std::pow(part.area, 1.5); };
  const auto is_reached = [](const Part& part) {
    return std::abs(part.length) * part.area <= std::abs(part.wanted)
        && std::abs(part.volume - part.wanted) <= 1e-6 * std::abs(part.wanted);
  };
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    const Part& part = parts[std::size_t(components.of_vertex[std::size_t(v)])];
    if(part.length != 0 && has_volume(part) && is_reached(part)) // else to the bit
      after[std::size_t(v)] = moved[std::size_t(v)];
  }
  return int(std::count_if(parts.begin(), parts.end(), [&](const Part& part) {
    return part.origin >= 0 && has_volume(part) && !is_reached(part);
  }));
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_OFFSET_TO_VOLUMES_IMPL_H
