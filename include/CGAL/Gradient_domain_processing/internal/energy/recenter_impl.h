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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_RECENTER_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_RECENTER_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/energy/recenter.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/connected_components.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE void recenter(const Indexed_triangles& mesh, const Triangle_metrics& metrics,
                              const Energy_weights& weights, const std::vector<char>& is_constrained,
                              Signal& displacement)
{
  Energy_weights value_weights = weights;
  value_weights.set_gradient(0);

  const Components components = connected_components(mesh);
  std::vector<double> mass(components.count, 0);
  std::vector<char> has_constraint(components.count, 0), is_at_rest(mesh.number_of_vertices(), 1);
  Signal moment = Signal::Zero(components.count, displacement.cols());
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    double weight = 0;
    for(const int* c = mesh.corners.begin(v); c != mesh.corners.end(v); ++c)
    {
      const Triangle_coefficients coefficients = triangle_coefficients(metrics(mesh, *c / 3));
      const Row_entries values = row_entries(mesh, coefficients, value_weights, *c);
      weight += values.vv + values.va + values.vb;
      if(row_entries(mesh, coefficients, weights, *c).vv != 0)
        is_at_rest[v] = 0;
    }
    const int component = components.of_vertex[v];
    mass[component] += weight;
    moment.row(component) += weight * displacement.row(v);
    if(is_constrained[v] || mesh.corners.size(v) == 0)
      has_constraint[component] = 1;
  }
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    const int component = components.of_vertex[v];
    if(!has_constraint[component] && !is_at_rest[v] && mass[component] > 0)
      displacement.row(v) -= moment.row(component) / mass[component];
  }
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_RECENTER_IMPL_H
