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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_FLOATING_COMPONENTS_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_FLOATING_COMPONENTS_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/energy/floating_components.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Disjoint_sets.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Pieces that stiffness makes of vertices. One that neither a constrained vertex nor a value weight holds has no unique
// solution.
class Stiff_pieces
{
  Disjoint_sets m_sets;
  std::vector<char> m_is_stiff, m_is_held;

public:
  explicit Stiff_pieces(int n) : m_sets(n), m_is_stiff(n, 0), m_is_held(n, 0) {}

  void connect(int v, int w)
  {
    m_is_stiff[v] = m_is_stiff[w] = 1;
    m_sets.join(v, w);
  }
  void hold(int v) { m_is_held[v] = 1; }

  bool is_any_floating()
  {
    std::vector<char> is_held(m_is_held.size(), 0);
    for(std::size_t v = 0; v < m_is_held.size(); ++v)
      if(m_is_held[v])
        is_held[m_sets.root(int(v))] = 1;
    for(std::size_t v = 0; v < m_is_stiff.size(); ++v)
      if(m_is_stiff[v] && !is_held[m_sets.root(int(v))])
        return true;
    return false;
  }
};

CGAL_GDP_INLINE bool has_floating_component(const Indexed_triangles& mesh, const Energy_weights& weights,
                                            bool has_second_order, const std::vector<char>& is_constrained)
{
  if(weights.value_at_vertex.empty() && weights.value > 0)
    return false;
  Stiff_pieces pieces(mesh.number_of_vertices());
  for(int f = 0; f < mesh.number_of_triangles(); ++f)
  {
    const auto& t = mesh.triangles[f];
    if(has_second_order || weights.gradient_at(f) > 0)
      for(int i = 1; i < 3; ++i)
        pieces.connect(t[0], t[i]);
    if(weights.value_at(t[0]) > 0 || weights.value_at(t[1]) > 0 || weights.value_at(t[2]) > 0)
      for(int v : t)
        pieces.hold(v);
  }
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    if(is_constrained[v])
      pieces.hold(v);
  return pieces.is_any_floating();
}

CGAL_GDP_INLINE bool has_floating_border(const Indexed_triangles& mesh, const std::vector<Border_edge>& edges,
                                         const Energy_weights& weights, const std::vector<char>& is_constrained)
{
  Stiff_pieces pieces(mesh.number_of_vertices());
  for(const Border_edge& e : edges)
  {
    const auto& t = mesh.triangles[e.triangle];
    const int v = t[e.from], w = t[e.to];
    if(weights.gradient_at(e.triangle) > 0)
      pieces.connect(v, w);
    const bool has_value = weights.value_at(v) > 0 || weights.value_at(w) > 0;
    for(int end : {v, w})
      if(has_value || is_constrained[end])
        pieces.hold(end);
  }
  return pieces.is_any_floating();
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_FLOATING_COMPONENTS_IMPL_H
