// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_SIGNAL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_SIGNAL_H

#include <CGAL/Gradient_domain_processing/internal/filtering/Filter.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/signals.h>

#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Which rows have a channel without a value.
std::vector<char> missing_rows(const Signal& signal);

// Weights that ask for no gradient on the faces of missing values.
Energy_weights without_gradients_at(const std::vector<char>& is_missing, const Indexed_triangles& mesh, Energy_weights weights);

// Fills missing values in by the energy without a value weight, all others constrained: as smoothly as the metric has it.
template <class Void = void>
Error_code fill_missing_values(const std::vector<char>& is_missing, Filter& filter, Signal& signal);

template <class InMap, class OutMap, class Surface>
Error_code filter_signal(InMap in, OutMap out, int number_of_iterations, bool may_be_missing, const Surface_elements<Surface>& elements,
                         Filter& filter)
{
  if(number_of_iterations < 0)
    return error_invalid_parameter;
  if(const Error_code code = filter.ready())
    return code;
  Signal signal;
  {
    Stage_scope stage(filter.progress(), Stage::READ);
    if(const Error_code code = read_signal(in, elements, filter.mesh(), may_be_missing, filter.culprit, signal))
      return code;
  }
  const Energy_weights own = filter.system.weights();
  const bool has_missing = may_be_missing && !signal.allFinite();
  Error_code code = ok;
  if(has_missing)
  {
    const std::vector<char> is_missing = missing_rows(signal);
    code = fill_missing_values(is_missing, filter, signal);
    filter.system.set_weights(without_gradients_at(is_missing, filter.mesh(), own));
  }
  for(int i = 0; i < number_of_iterations && code == ok; ++i)
    code = filter.filter(signal);
  if(has_missing)
    filter.system.set_weights(own);
  if(code != ok || (code = filter.ready()) != ok)
    return code;
  Stage_scope stage(filter.progress(), Stage::WRITE);
  return write_signal(in, signal, out, elements, filter.mesh(), [&](int v) { return filter.is_moved(v); }, filter.culprit);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/filtering/filter_signal_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_SIGNAL_H
