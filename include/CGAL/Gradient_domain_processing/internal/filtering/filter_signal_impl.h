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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_SIGNAL_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_SIGNAL_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/filtering/filter_signal.h>
#include <CGAL/Gradient_domain_processing/internal/energy/target_field/Scaled_gradient.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/At_end.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Which rows have a channel without a value.
inline std::vector<char> missing_rows(const Signal& signal)
{
  std::vector<char> is_missing(std::size_t(signal.rows()));
  for(std::size_t row = 0; row < is_missing.size(); ++row)
    is_missing[row] = !signal.row(Eigen::Index(row)).allFinite();
  return is_missing;
}

// Weights that ask for no gradient on the faces of missing values.
inline Energy_weights without_gradients_at(const std::vector<char>& is_missing, const Indexed_triangles& mesh,
                                           Energy_weights weights)
{
  if(weights.scale_at_triangle.empty())
    weights.scale_at_triangle.assign(mesh.triangles.size(), weights.scale);
  for(int f = 0; f < mesh.number_of_triangles(); ++f)
    for(int row : mesh.rows_of(f))
      if(is_missing[std::size_t(row)])
        weights.scale_at_triangle[std::size_t(f)] = 0;
  return weights;
}

template <class Void = void>
Error_code fill_missing_values(const std::vector<char>& is_missing, Filter& filter, Signal& signal)
{
  Linear_system& system = filter.system;
  const At_end scope([&system, own_constrained = system.is_constrained, own_weights = system.weights()] {
    system.set_constrained(own_constrained);
    system.set_weights(own_weights);
  });
  const Indexed_triangles& mesh = filter.mesh();
  // where one side of a seam has a value, the others take it
  std::vector<int> number_of_values(mesh.points.size(), 0);
  Signal filled = signal, sums = Signal::Zero(mesh.number_of_vertices(), signal.cols());
  for(int row = 0; row < mesh.number_of_rows(); ++row)
    if(!is_missing[std::size_t(row)])
    {
      sums.row(mesh.vertex_of(row)) += signal.row(row);
      ++number_of_values[std::size_t(mesh.vertex_of(row))];
    }
  std::vector<char> has_value(mesh.points.size(), 1);
  for(int row = 0; row < mesh.number_of_rows(); ++row)
    if(is_missing[std::size_t(row)])
    {
      const int v = mesh.vertex_of(row), n = number_of_values[std::size_t(v)];
      has_value[std::size_t(v)] = n > 0;
      filled.row(row) = sums.row(v) / (std::max)(1, n);
    }
  interpolate_virtual_rows(mesh, filled);
  Energy_weights weights;
  weights.value = 0;
  weights.gradient = 1;
  filter.system.set_constrained(std::move(has_value));
  filter.system.set_weights(weights);
  Signal change;
  if(const Error_code code =
       filter.system.solve(Scaled_gradient(mesh, filter.system.weights(), filled), filter.progress(), change))
    return code;
  filter.add(change, filled);
  for(Eigen::Index i = 0; i < signal.size(); ++i)
    if(!std::isfinite(signal.data()[i]))
      signal.data()[i] = filled.data()[i];
  return ok;
}

template <class Void>
Error_code filter_repeatedly(int number_of_iterations, Filter& filter, Signal& signal)
{
  Error_code code = ok;
  for(int i = 0; i < number_of_iterations && code == ok; ++i)
    code = filter.filter(signal);
  return code;
}

template <class Void>
Error_code fill_and_filter(int number_of_iterations, Filter& filter, Signal& signal)
{
  const Energy_weights own = filter.system.weights();
  const At_end scope([&] { filter.system.set_weights(own); });
  const std::vector<char> is_missing = missing_rows(signal);
  if(const Error_code code = fill_missing_values(is_missing, filter, signal))
    return code;
  filter.system.set_weights(without_gradients_at(is_missing, filter.mesh(), own));
  return filter_repeatedly(number_of_iterations, filter, signal);
}

#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
template Error_code filter_repeatedly<>(int number_of_iterations, Filter& filter, Signal& signal);
template Error_code fill_and_filter<>(int number_of_iterations, Filter& filter, Signal& signal);
#endif

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_SIGNAL_IMPL_H
