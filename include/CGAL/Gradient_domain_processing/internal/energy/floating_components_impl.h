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

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Pieces that stiffness makes of vertices. One that neither enough constrained vertices nor a value weight holds has no
// unique solution.
class Stiff_pieces
{
  Disjoint_sets m_sets;
  std::vector<char> m_is_stiff, m_has_gradient, m_has_value, m_is_constrained;

public:
  explicit Stiff_pieces(int n)
    : m_sets(n)
    , m_is_stiff(n, 0)
    , m_has_gradient(n, 0)
    , m_has_value(n, 0)
    , m_is_constrained(n, 0)
  {
  }

  void connect(int v, int w, bool has_gradient)
  {
    m_is_stiff[v] = m_is_stiff[w] = 1;
    if(has_gradient)
      m_has_gradient[v] = 1;
    m_sets.join(v, w);
  }
  void hold(int v) { m_has_value[v] = 1; }
  void constrain(int v) { m_is_constrained[v] = 1; }

  // `needed` constrained vertices where no gradients count, else one.
  bool is_any_floating(int needed)
  {
    std::vector<int> count(m_is_stiff.size(), 0), least(m_is_stiff.size(), needed);
    for(std::size_t v = 0; v < m_is_stiff.size(); ++v)
    {
      const int root = m_sets.root(int(v));
      count[root] += m_has_value[v] ? needed : m_is_constrained[v];
      if(m_has_gradient[v])
        least[root] = 1;
    }
    for(std::size_t v = 0; v < m_is_stiff.size(); ++v)
      if(m_is_stiff[v] && count[m_sets.root(int(v))] < least[m_sets.root(int(v))])
        return true;
    return false;
  }
};

CGAL_GDP_INLINE bool has_floating_component(const Indexed_triangles& mesh, const Energy_weights& weights,
                                            int constraints_of_second_order, const std::vector<char>& is_constrained)
{
  if(weights.value_at_vertex.empty() && weights.value > 0)
    return false;
  Stiff_pieces pieces(mesh.number_of_vertices());
  for(int f = 0; f < mesh.number_of_triangles(); ++f)
  {
    const auto& t = mesh.triangles[f];
    const bool has_gradient = weights.gradient_at(f) > 0;
    if(constraints_of_second_order > 0 || has_gradient)
      for(int i = 1; i < 3; ++i)
        pieces.connect(t[0], t[i], has_gradient);
    if(weights.value_at(t[0]) > 0 || weights.value_at(t[1]) > 0 || weights.value_at(t[2]) > 0)
      for(int v : t)
        pieces.hold(v);
  }
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    if(is_constrained[v])
      pieces.constrain(v);
  return pieces.is_any_floating((std::max)(1, constraints_of_second_order));
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
      pieces.connect(v, w, true);
    const bool has_value = weights.value_at(v) > 0 || weights.value_at(w) > 0;
    for(int end : {v, w})
      if(has_value || is_constrained[end])
        pieces.hold(end);
  }
  return pieces.is_any_floating(1);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_FLOATING_COMPONENTS_IMPL_H
