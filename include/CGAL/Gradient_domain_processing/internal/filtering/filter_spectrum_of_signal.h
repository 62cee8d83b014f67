// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_SPECTRUM_OF_SIGNAL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_SPECTRUM_OF_SIGNAL_H

#include <CGAL/Gradient_domain_processing/internal/filtering/Filter.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/connected_components.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/signals.h>
#include <CGAL/Gradient_domain_processing/internal/spectrum/Spectral_system.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// One value a vertex: where several were welded, their mean.
inline Signal mean_by_vertex(const Indexed_triangles& mesh, const Signal& signal)
{
  Signal means = Signal::Zero(mesh.number_of_vertices(), signal.cols());
  std::vector<int> count(mesh.points.size(), 0);
  for(int row = 0; row < mesh.number_of_rows(); ++row)
  {
    means.row(mesh.vertex_of(row)) += signal.row(row);
    ++count[std::size_t(mesh.vertex_of(row))];
  }
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    if(count[std::size_t(v)] > 1)
      means.row(v) /= count[std::size_t(v)];
  return means;
}

// What a signal by vertex has beside the harmonic function that agrees with it at the constrained vertices: the part that
// harmonics, which are zero there, make up. In components without such vertices it is all of the signal.
template <class Solver>
Error_code subtract_harmonic_extension(Filter<Solver>& filter, Signal& signal)
{
  const std::vector<char> own_constrained = filter.system.is_constrained;
  if(std::find(own_constrained.begin(), own_constrained.end(), 1) == own_constrained.end())
    return ok;
  struct Restored
  {
    Linear_system<Solver>& system;
    std::vector<char> is_constrained;
    Energy_weights weights;
    ~Restored()
    {
      system.set_constrained(std::move(is_constrained));
      system.set_weights(weights);
    }
  };
  const Indexed_triangles& mesh = filter.mesh();
  const Restored scope{filter.system, own_constrained, filter.system.weights()};
  const Components components = connected_components(mesh);
  std::vector<char> floats(std::size_t(components.count), 1);
  for(std::size_t v = 0; v < own_constrained.size(); ++v)
    if(own_constrained[v])
      floats[std::size_t(components.of_vertex[v])] = 0;
  std::vector<char> constrained = own_constrained;
  for(std::size_t v = 0; v < constrained.size(); ++v)
    if(floats[std::size_t(components.of_vertex[v])])
      constrained[v] = 1;
  Energy_weights weights;
  weights.value = 0;
  weights.gradient = 1;
  weights.set_scale(0);
  filter.system.set_constrained(constrained);
  filter.system.set_weights(weights);
  Signal change;
  if(const Error_code code = filter.solve_by_vertex(signal, change))
    return code;
  for(std::size_t v = 0; v < constrained.size(); ++v)
    if(!floats[std::size_t(components.of_vertex[v])])
      signal.row(Eigen::Index(v)) = -change.row(Eigen::Index(v));
  return ok;
}

// `apply` filters a matrix of values by degree of freedom, given the system.
template <class InMap, class OutMap, class Surface, class Solver, class Apply>
Error_code filter_spectrum_of_signal(InMap in, OutMap out, const Solver& solver, const Surface_elements<Surface>& elements,
                                     Filter<Solver>& filter, const Apply& apply)
{
  if(const Error_code code = filter.ready())
    return code;
  const Indexed_triangles& mesh = filter.mesh();
  Signal signal;
  {
    Stage_scope stage(filter.progress(), Stage::READ);
    if(const Error_code code = read_signal(in, elements, mesh, false, filter.culprit, signal))
      return code;
  }
  Signal part = mean_by_vertex(mesh, signal);
  if(const Error_code code = subtract_harmonic_extension(filter, part))
    return code;
  Spectral_system<Solver> system(solver, filter.system.parallel);
  if(const Error_code code = system.assemble_matrices(mesh, filter.system.metrics(), filter.system.is_constrained, filter.progress()))
    return code;
  const Degrees_of_freedom& dofs = system.degrees_of_freedom();
  Signal change = Signal::Zero(mesh.number_of_vertices(), signal.cols());
  if(dofs.size() > 0)
  {
    Eigen::MatrixXd values(dofs.size(), signal.cols());
    for_each_degree_of_freedom(system.is_parallel(), dofs, [&](int v, int i) { values.row(i) = part.row(v); });
    if(const Error_code code = apply(system, values))
      return code;
    for_each_degree_of_freedom(system.is_parallel(), dofs, [&](int v, int i) { change.row(v) = values.row(i) - part.row(v); });
  }
  filter.add(change, signal);
  if(const Error_code code = filter.ready())
    return code;
  Stage_scope stage(filter.progress(), Stage::WRITE);
  return write_signal(in, signal, out, elements, mesh, [&](int v) { return mesh.corners.size(v) > 0 && !filter.system.is_constrained[std::size_t(v)]; },
                      filter.culprit);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_SPECTRUM_OF_SIGNAL_H
