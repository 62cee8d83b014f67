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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_SPECTRUM_OF_SIGNAL_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_SPECTRUM_OF_SIGNAL_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/filtering/filter_spectrum_of_signal.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/At_end.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/connected_components.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE Error_code subtract_harmonic_extension(Filter& filter, Signal& signal)
{
  const std::vector<char> own_constrained = filter.system.is_constrained;
  if(std::find(own_constrained.begin(), own_constrained.end(), 1) == own_constrained.end())
    return ok;
  const Indexed_triangles& mesh = filter.mesh();
  const Components components = connected_components(mesh);
  std::vector<char> floats(std::size_t(components.count), 1);
  for(std::size_t v = 0; v < own_constrained.size(); ++v)
    if(own_constrained[v])
      floats[std::size_t(components.of_vertex[v])] = 0;
  std::vector<char> constrained = own_constrained;
  for(std::size_t v = 0; v < constrained.size(); ++v)
    if(floats[std::size_t(components.of_vertex[v])])
      constrained[v] = 1;
  Linear_system::Coefficients of_extension;
  of_extension.metrics = filter.system.metrics();
  of_extension.weights.value = 0;
  of_extension.weights.gradient = 1;
  const Border_condition of_border = filter.border_condition, of_lines = filter.line_condition;
  Linear_system::Coefficients own = filter.system.exchange_coefficients(std::move(of_extension));
  const At_end scope([&] {
    filter.border_condition = of_border;
    filter.line_condition = of_lines;
    filter.system.set_constrained(own_constrained);
    filter.system.exchange_coefficients(std::move(own));
  });
  filter.border_condition = filter.line_condition = Border_condition::FREE; // what is a curve of its own is fixed here
  filter.system.set_constrained(constrained);
  Signal change;
  if(const Error_code code = filter.solve_by_vertex(signal, change))
    return code;
  for(std::size_t v = 0; v < constrained.size(); ++v)
    if(!floats[std::size_t(components.of_vertex[v])])
      signal.row(Eigen::Index(v)) = -change.row(Eigen::Index(v));
  return ok;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_SPECTRUM_OF_SIGNAL_IMPL_H
