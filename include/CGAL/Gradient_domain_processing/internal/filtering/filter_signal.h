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

// Weights under which missing values are filled in: these have none, and no gradient is asked for on their faces. The values
// themselves become the mean of those that are there, from which the solution starts.
inline Energy_weights weights_without(const Indexed_triangles& mesh, Energy_weights weights, Signal& signal)
{
  std::vector<char> is_missing(signal.rows(), 0);
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(signal.cols());
  double count = 0;
  for(int row = 0; row < int(signal.rows()); ++row)
    if(signal.row(row).allFinite())
    {
      mean += signal.row(row).transpose();
      ++count;
    }
    else
      is_missing[row] = 1;
  if(count == double(signal.rows()))
    return weights;
  mean /= (std::max)(count, 1.);
  if(weights.value_at_vertex.empty())
    weights.value_at_vertex.assign(mesh.points.size(), weights.value);
  if(weights.scale_at_triangle.empty())
    weights.scale_at_triangle.assign(mesh.triangles.size(), weights.scale);
  for(int row = 0; row < int(signal.rows()); ++row)
    if(is_missing[row])
    {
      weights.value_at_vertex[mesh.vertex_of(row)] = 0;
      signal.row(row) = mean.transpose();
    }
  for(int f = 0; f < mesh.number_of_triangles(); ++f)
    for(int row : mesh.rows_of(f))
      if(is_missing[row])
        weights.scale_at_triangle[f] = 0;
  return weights;
}

template <class InMap, class OutMap, class Surface, class Solver>
Error_code filter_signal(InMap in, OutMap out, int number_of_iterations, bool may_be_missing, const Surface_elements<Surface>& elements,
                         Filter<Solver>& filter)
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
  if(has_missing)
    filter.system.set_weights(weights_without(filter.mesh(), own, signal));
  Error_code code = ok;
  for(int i = 0; i < number_of_iterations && code == ok; ++i)
  {
    code = filter.filter(signal);
    if(has_missing && i == 0)
      filter.system.set_weights(own);
  }
  if(code != ok || (code = filter.ready()) != ok)
    return code;
  Stage_scope stage(filter.progress(), Stage::WRITE);
  return write_signal(in, signal, out, elements, filter.mesh(), [&](int v) { return filter.is_moved(v); }, filter.culprit);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_SIGNAL_H
