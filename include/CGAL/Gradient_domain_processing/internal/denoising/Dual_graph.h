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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_DUAL_GRAPH_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_DUAL_GRAPH_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The triangles as nodes, an edge between any two that share an edge of the mesh with no third one. So no triangle has
// more than three neighbors, whatever the mesh.
class Dual_graph
{
  std::vector<std::array<int, 3> > m_neighbors;
  std::vector<signed char> m_signs; // empty where all are 1

public:
  Dual_graph(const Indexed_triangles& mesh, bool parallel) : m_neighbors(mesh.triangles.size())
  {
    parallel_for(parallel, m_neighbors.size(), [&](std::size_t f) {
      for(int i = 0; i < 3; ++i)
        m_neighbors[f][i] = find_neighbor(mesh, int(f), i);
    });
    orient(mesh);
  }

  int size() const { return int(m_neighbors.size()); }

  // Across the edge from corner i to the next; -1 where there is none.
  int neighbor(int f, int i) const { return m_neighbors[f][i]; }
  const std::array<int, 3>& neighbors(int f) const { return m_neighbors[f]; }

  // No other triangle has the edge from corner i to the next.
  bool is_border(const Indexed_triangles& mesh, int f, int i) const
  {
    if(m_neighbors[f][i] >= 0)
      return false;
    const int v = mesh.triangles[f][i], w = mesh.triangles[f][(i + 1) % 3];
    int count = 0;
    for(const int* c = mesh.corners.begin(v); c != mesh.corners.end(v); ++c)
      count += contains(mesh.triangles[*c / 3], w);
    return count == 1;
  }

  // -1 where a triangle has to be turned over for its component to be oriented.
  double sign(int f) const { return m_signs.empty() ? 1 : m_signs[f]; }

  // visit(f, g, v, w) for all edges, from vertex v to vertex w in triangle f.
  template <class Visit>
  void for_each_edge(const Indexed_triangles& mesh, const Visit& visit) const
  {
    for(int f = 0; f < size(); ++f)
      for(int i = 0; i < 3; ++i)
        if(m_neighbors[f][i] > f)
          visit(f, m_neighbors[f][i], mesh.triangles[f][i], mesh.triangles[f][(i + 1) % 3]);
  }

private:
  static bool contains(const std::array<int, 3>& t, int v) { return t[0] == v || t[1] == v || t[2] == v; }

  static int find_neighbor(const Indexed_triangles& mesh, int f, int i)
  {
    const int v = mesh.triangles[f][i], w = mesh.triangles[f][(i + 1) % 3];
    int found = -1;
    for(const int* c = mesh.corners.begin(v); c != mesh.corners.end(v); ++c)
      if(*c / 3 != f && contains(mesh.triangles[*c / 3], w))
      {
        if(found >= 0)
          return -1;
        found = *c / 3;
      }
    return found;
  }

  static bool agree(const Indexed_triangles& mesh, int f, int i, int g)
  {
    const int v = mesh.triangles[f][i], w = mesh.triangles[f][(i + 1) % 3];
    const auto& t = mesh.triangles[g];
    for(int j = 0; j < 3; ++j)
      if(t[j] == w && t[(j + 1) % 3] == v)
        return true;
    return false;
  }

  bool is_oriented(const Indexed_triangles& mesh) const
  {
    for(int f = 0; f < size(); ++f)
      for(int i = 0; i < 3; ++i)
        if(m_neighbors[f][i] > f && !agree(mesh, f, i, m_neighbors[f][i]))
          return false;
    return true;
  }

  // Breadth first. On a Moebius strip, edges remain across which no choice of signs agrees: they are left out.
  void orient(const Indexed_triangles& mesh)
  {
    if(is_oriented(mesh))
      return;
    m_signs.assign(m_neighbors.size(), 0);
    std::vector<int> queue;
    for(int seed = 0; seed < size(); ++seed)
    {
      if(m_signs[seed] != 0)
        continue;
      m_signs[seed] = 1;
      queue.assign(1, seed);
      for(std::size_t next = 0; next < queue.size(); ++next)
        for(int i = 0; i < 3; ++i)
        {
          const int f = queue[next], g = m_neighbors[f][i];
          if(g < 0 || m_signs[g] != 0)
            continue;
          m_signs[g] = agree(mesh, f, i, g) ? m_signs[f] : static_cast<signed char>(-m_signs[f]);
          queue.push_back(g);
        }
    }
    for(int f = 0; f < size(); ++f)
      for(int i = 0; i < 3; ++i)
      {
        const int g = m_neighbors[f][i];
        if(g >= 0 && (m_signs[f] == m_signs[g]) != agree(mesh, f, i, g))
          m_neighbors[f][i] = -1;
      }
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_DUAL_GRAPH_H
