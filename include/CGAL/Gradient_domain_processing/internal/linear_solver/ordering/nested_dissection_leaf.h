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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_NESTED_DISSECTION_LEAF_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_NESTED_DISSECTION_LEAF_H

#include <bitset>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Exact minimum degree on a graph so small that a row of its elimination graph is a few machine words.
// Boundary vertices count in the degrees but are not eliminated: their turn comes with a separator.
class Leaf_elimination
{
public:
  static constexpr int max_number_of_interior_vertices = 128;
  static constexpr int max_number_of_vertices = 256;

  void reset(int number_of_interior_vertices)
  {
    m_rows.assign(number_of_interior_vertices, Row());
  }

  // Boundary vertices are numbered after the interior ones; those too many to fit are left out of the degrees.
  void connect(int interior, int other)
  {
    if(other < max_number_of_vertices) m_rows[interior].set(other);
  }

  // Elimination order of the interior vertices.
  const std::vector<int>& compute()
  {
    const int n = int(m_rows.size());
    m_order.clear();
    m_degrees.resize(n);
    for(int v = 0; v < n; ++v) m_degrees[v] = int(m_rows[v].count());
    while(int(m_order.size()) < n) eliminate(vertex_of_minimum_degree());
    return m_order;
  }

private:
  using Row = std::bitset<max_number_of_vertices>;
  static constexpr int eliminated = max_number_of_vertices;

  int vertex_of_minimum_degree() const
  {
    int best = 0;
    for(int v = 1; v < int(m_degrees.size()); ++v)
      if(m_degrees[v] < m_degrees[best]) best = v;
    return best;
  }

  // The neighbors of v become a clique.
  void eliminate(int v)
  {
    const Row clique = m_rows[v];
    m_order.push_back(v);
    m_degrees[v] = eliminated;
    for(int u = 0; u < int(m_rows.size()); ++u) {
      if(!clique[u]) continue;
      m_rows[u] |= clique;
      m_rows[u].reset(u).reset(v);
      m_degrees[u] = int(m_rows[u].count());
    }
  }

  std::vector<Row> m_rows;
  std::vector<int> m_degrees, m_order;
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_NESTED_DISSECTION_LEAF_H
