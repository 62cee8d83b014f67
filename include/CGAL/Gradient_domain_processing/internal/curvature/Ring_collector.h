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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_RING_COLLECTOR_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_RING_COLLECTOR_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Rings of vertices around a vertex by breadth-first search, one ring at a time. A vertex whose normal points away from
// the center's is another sheet of the surface (the far side of a thin part) and ends the search there.
// Visits are stamped, so that a new start costs nothing; one object serves one thread.
class Ring_collector
{
public:
  Ring_collector(const std::vector<int>& offsets, const std::vector<int>& neighbors, const std::vector<Vec3>& normals)
    : m_offsets(offsets), m_neighbors(neighbors), m_normals(normals), m_stamps(normals.size(), 0), m_stamp(0)
  { }

  void start(int v)
  {
    ++m_stamp;
    m_stamps[v] = m_stamp;
    m_vertices.assign(1, v);
    m_ring_begin = 0;
  }

  // Adds the next ring, thinned evenly if there would be more than `max_size` vertices. False if nothing is left to
  // add.
  bool add_ring(std::size_t max_size)
  {
    const std::size_t ring_end = m_vertices.size();
    const Vec3& normal = m_normals[m_vertices.front()];
    for(std::size_t i = m_ring_begin; i < ring_end; ++i)
    {
      const int v = m_vertices[i];
      for(int j = m_offsets[v]; j < m_offsets[v + 1]; ++j)
      {
        const int w = m_neighbors[j];
        if(m_stamps[w] == m_stamp)
          continue;
        m_stamps[w] = m_stamp;
        if(!(normal.dot(m_normals[w]) < 0))
          m_vertices.push_back(w);
      }
    }
    m_ring_begin = ring_end;

    if(m_vertices.size() > max_size)
    {
      const std::size_t found = m_vertices.size() - ring_end;
      const std::size_t kept = ring_end < max_size ? max_size - ring_end : 0;
      for(std::size_t i = 0; i < kept; ++i)
        m_vertices[ring_end + i] = m_vertices[ring_end + i * found / kept];
      m_vertices.resize(ring_end + kept);
    }
    return m_vertices.size() > ring_end;
  }

  // The center first.
  const std::vector<int>& vertices() const { return m_vertices; }

private:
  const std::vector<int>& m_offsets;
  const std::vector<int>& m_neighbors;
  const std::vector<Vec3>& m_normals;
  std::vector<unsigned int> m_stamps;
  unsigned int m_stamp;
  std::vector<int> m_vertices;
  std::size_t m_ring_begin;
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_RING_COLLECTOR_H
