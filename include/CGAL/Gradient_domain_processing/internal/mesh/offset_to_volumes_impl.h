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
  for(int k = 0; k < mesh.virtual_vertices.size(); ++k)
    offsets[std::size_t(mesh.first_virtual_vertex() + k)] = mesh.virtual_vertices.mean(k, [&](int row) {
      return offsets[std::size_t(mesh.vertex_of(row))];
    });
  return offsets;
}

// The components of a surface, each with its offset.
class Volume_offsets
{
  struct Part
  {
    double wanted = 0, area = 0, length = 0, volume = 0, slope = 0; // `length` of the offset
    int origin = -1;

    bool has_volume() const { return std::abs(wanted) > 1e-9 * std::pow(area, 1.5); }
    bool is_reached() const
    {
      return std::abs(length) * area <= std::abs(wanted) && std::abs(volume - wanted) <= 1e-6 * std::abs(wanted);
    }
  };
  const Indexed_triangles& m_mesh;
  const std::vector<Vec3>& m_before;
  Components m_components;
  std::vector<Part> m_parts;

  int part_of_vertex(int v) const { return m_components.of_vertex[std::size_t(v)]; }
  Part& part_of(int f) { return m_parts[std::size_t(part_of_vertex(m_mesh.triangles[std::size_t(f)][0]))]; }

  // of the tetrahedron of a triangle and an origin in its component
  double volume(int f, const std::vector<Vec3>& points)
  {
    const Vec3& origin = m_before[std::size_t(part_of(f).origin)];
    return m_mesh.area_vector(f, points).dot(points[std::size_t(m_mesh.triangles[std::size_t(f)][0])] - origin) / 6;
  }

public:
  Volume_offsets(const Indexed_triangles& mesh, const std::vector<Vec3>& before)
    : m_mesh(mesh)
    , m_before(before)
    , m_components(connected_components(mesh))
    , m_parts(std::size_t(m_components.count))
  {
    for(int f = 0; f < mesh.number_of_triangles(); ++f)
    {
      Part& part = part_of(f);
      if(part.origin < 0)
        part.origin = mesh.triangles[std::size_t(f)][0];
      part.wanted += volume(f, before);
      part.area += mesh.area_vector(f, before).norm() / 2;
    }
  }

  // A step of Newton's.
  void improve(const std::vector<Vec3>& offsets, const std::vector<Vec3>& moved)
  {
    for(Part& part : m_parts)
      part.volume = part.slope = 0;
    for(int f = 0; f < m_mesh.number_of_triangles(); ++f)
    {
      Part& part = part_of(f);
      part.volume += volume(f, moved);
      for(int v : m_mesh.triangles[std::size_t(f)])
        part.slope += m_mesh.area_vector(f, moved).dot(offsets[std::size_t(v)]) / 6;
    }
    for(Part& part : m_parts)
      if(std::abs(part.wanted - part.volume) > 1e-13 * std::abs(part.wanted))
        part.length += (part.wanted - part.volume) / part.slope;
  }

  double length(int v) const { return m_parts[std::size_t(part_of_vertex(v))].length; }

  // Other vertices stay, to the bit.
  bool is_moved(int v) const
  {
    const Part& part = m_parts[std::size_t(part_of_vertex(v))];
    return part.length != 0 && part.has_volume() && part.is_reached();
  }

  int number_of_failures() const
  {
    return int(std::count_if(m_parts.begin(), m_parts.end(), [](const Part& part) {
      return part.origin >= 0 && part.has_volume() && !part.is_reached();
    }));
  }
};

CGAL_GDP_INLINE int offset_to_volumes(const Indexed_triangles& mesh, const std::vector<Vec3>& before, bool parallel,
                                      std::vector<Vec3>& after)
{
  Volume_offsets parts(mesh, before);
  const std::vector<Vec3> offsets = unit_offsets(mesh, after, parallel);
  std::vector<Vec3> moved = after;
  for(int step = 0; step < 8; ++step) // the volume is cubic
  {
    parts.improve(offsets, moved);
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      moved[std::size_t(v)] = after[std::size_t(v)] + parts.length(v) * offsets[std::size_t(v)];
  }
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    if(parts.is_moved(v))
      after[std::size_t(v)] = moved[std::size_t(v)];
  return parts.number_of_failures();
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_OFFSET_TO_VOLUMES_IMPL_H
