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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FACE_SIGNALS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FACE_SIGNALS_H

#include <CGAL/Gradient_domain_processing/Signal_traits.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/Filter.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/face_energy.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

template <class Solver, class InMap>
Error_code read_face_signal(Solver& solver, InMap in, Signal& signal)
{
  typedef Signal_traits<typename boost::property_traits<InMap>::value_type> Traits;
  const auto& faces = solver.elements().faces;
  signal.resize(Eigen::Index(faces.size()), Traits::dimension);
  for(std::size_t f = 0; f < faces.size(); ++f)
  {
    const auto& value = get(in, faces[f]);
    for(int i = 0; i < Traits::dimension; ++i)
    {
      signal(Eigen::Index(f), i) = Traits::channel(value, i);
      if(!std::isfinite(signal(Eigen::Index(f), i)))
      {
        solver.arrays().culprit.face = int(f);
        return solver.checked(error_invalid_signal);
      }
    }
  }
  return ok;
}

template <class Solver, class OutMap>
Error_code write_face_signal(Solver& solver, const Signal& signal, OutMap out)
{
  typedef typename boost::property_traits<OutMap>::value_type Value;
  typedef Signal_traits<Value> Traits;
  const auto& faces = solver.elements().faces;
  std::vector<Value> values;
  values.reserve(faces.size());
  for(std::size_t f = 0; f < faces.size(); ++f)
  {
    values.push_back(Traits::make(signal.row(Eigen::Index(f)).data()));
    for(int i = 0; i < Traits::dimension; ++i)
      if(!std::isfinite(Traits::channel(values.back(), i)))
      {
        solver.arrays().culprit.face = int(f);
        return solver.checked(error_result_out_of_range);
      }
  }
  for(std::size_t f = 0; f < faces.size(); ++f)
    put(out, faces[f], values[f]);
  return ok;
}

// The weight of an edge between two faces: the caller's, or that of the geometry; negative if the caller's is none.
template <class Solver, class Surface, class NamedParameters>
double edge_weight(Solver& solver, const Surface& surface, const std::vector<Vec3>& centers, int f, int i, int g,
                   const NamedParameters& np)
{
  const Indexed_triangles& mesh = solver.arrays().system.mesh;
  const std::array<int, 2> rows = edge_of_lower(mesh, f, i, g);
  if constexpr (Has_parameter<CGAL::internal_np::interior_edge_weight_map_t, NamedParameters>::value)
  {
    const auto h = halfedge(solver.elements().vertices[rows[0]], solver.elements().vertices[rows[1]], surface).first;
    const double weight =
      CGAL::to_double(get(parameter(np, CGAL::internal_np::interior_edge_weight_map, 0), edge(h, surface)));
    return is_weight(weight) ? weight : -1;
  }
  else
    return default_edge_weight(mesh.points[mesh.vertex_of(rows[0])], mesh.points[mesh.vertex_of(rows[1])],
                               centers[mesh.face_of((std::min)(f, g))], centers[mesh.face_of((std::max)(f, g))]);
}

template <class Solver, class Surface, class NamedParameters>
Error_code read_face_energy(Solver& solver, const Surface& surface, const NamedParameters& np, Face_energy& energy)
{
  const Indexed_triangles& mesh = solver.arrays().system.mesh;
  const Energy_weights& weights = solver.arrays().system.weights();
  const Dual_graph dual(mesh, solver.arrays().system.parallel);
  const std::size_t n = solver.elements().faces.size();
  const std::vector<Vec3> centers = face_centers(mesh, n);
  energy.values.assign(n, 0.);
  energy.scales.assign(n, 0.);
  count_neighbors(mesh, dual, energy);
  std::vector<int> next(energy.first_neighbor.begin(), energy.first_neighbor.end() - 1);
  for(int f = 0; f < dual.size(); ++f)
  {
    const int face = mesh.face_of(f);
    energy.values[face] += weights.value * solver.arrays().system.metric(f).area();
    energy.scales[face] = weights.scale_at(f);
    for(int i = 0; i < 3; ++i)
    {
      const int g = dual.neighbor(f, i);
      if(g < 0 || mesh.face_of(g) == face)
        continue;
      const double weight = edge_weight(solver, surface, centers, f, i, g, np);
      if(weight < 0)
      {
        solver.arrays().culprit.face = face;
        return solver.checked(error_invalid_weight);
      }
      energy.neighbors[next[face]++] = {mesh.face_of(g),
                                        (weights.gradient_at(f) + weights.gradient_at(g)) / 2 * weight};
    }
  }
  for(std::size_t f = 0; f < n; ++f)
  {
    if(!(energy.values[f] > 0))
      energy.values[f] = weights.value; // a face shrunk to a point has no area, but a value
    double diagonal = energy.values[f];
    energy.for_each_neighbor(int(f), [&](const Face_energy::Neighbor& g) { diagonal += g.weight; });
    energy.inverse_diagonal.push_back(1 / diagonal);
  }
  return ok;
}

template <class Solver, class Surface, class InMap, class OutMap, class NamedParameters>
Error_code process_face_signal(Solver solver, const Surface& surface, InMap in, OutMap out, const NamedParameters& np)
{
  typedef Signal_traits<typename boost::property_traits<InMap>::value_type> In_traits;
  typedef Signal_traits<typename boost::property_traits<OutMap>::value_type> Out_traits;
  static_assert(In_traits::dimension == Out_traits::dimension, "input and output have as many channels");
  if(solver.error() != ok)
    return solver.error();
  if(solver.arrays().system.weights().value == 0)
    return error_unconstrained;

  Signal signal;
  if(const Error_code code = read_face_signal(solver, in, signal))
    return code;
  Face_energy energy;
  if(const Error_code code = read_face_energy(solver, surface, np, energy))
    return code;
  {
    Stage_scope stage(solver.progress(), Stage::SOLVE);
    if(const Error_code code = filter_face_signal(energy, solver.arrays().system.parallel, solver.progress(), signal))
      return code;
  }
  return write_face_signal(solver, signal, out);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FACE_SIGNALS_H
