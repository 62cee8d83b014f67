// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FACE_SIGNALS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FACE_SIGNALS_H

#include <CGAL/Gradient_domain_processing/Signal_traits.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/filter_face_signal.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/Filter.h>

#include <algorithm>
#include <cmath>
#include <utility>
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

// The length of an edge divided by the distance of the centroids of its faces.
inline double default_edge_weight(const Indexed_triangles& mesh, int f, int g, int v, int w)
{
  const auto center = [&](int h) {
    const auto& t = mesh.triangles[h];
    return Vec3((mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3);
  };
  const double length = (mesh.points[v] - mesh.points[w]).norm();
  return length / (std::max)((center(f) - center(g)).norm(), degeneracy_ratio * (length > 0 ? length : 1.));
}

template <class Solver, class Surface, class NamedParameters>
Error_code read_face_energy(Solver& solver, const Surface& surface, const Dual_graph& dual, const NamedParameters& np, Face_energy& energy)
{
  namespace tag = CGAL::internal_np;
  const Indexed_triangles& mesh = solver.arrays().system.mesh;
  const Energy_weights& weights = solver.arrays().system.weights();
  const std::size_t n = mesh.triangles.size();
  energy.values.resize(n);
  energy.scales.resize(n);
  energy.gradients.assign(n, {{0, 0, 0}});
  for(int f = 0; f < dual.size(); ++f)
  {
    const double area = solver.arrays().system.metric(f).area();
    energy.values[f] = weights.value * (area > 0 ? area : 1.); // a face shrunk to a point has no area, but a value
    energy.scales[f] = weights.scale_at(f);
    for(int i = 0; i < 3; ++i)
    {
      const int g = dual.neighbor(f, i), v = mesh.triangles[f][i], w = mesh.triangles[f][(i + 1) % 3];
      if(g < 0)
        continue;
      double weight;
      if constexpr (Has_parameter<tag::interior_edge_weight_map_t, NamedParameters>::value)
      {
        const auto h = halfedge(solver.elements().vertices[v], solver.elements().vertices[w], surface).first;
        weight = CGAL::to_double(get(parameter(np, tag::interior_edge_weight_map, 0), edge(h, surface)));
        if(!(weight >= 0) || !std::isfinite(weight))
        {
          solver.arrays().culprit.face = f;
          return solver.checked(error_invalid_weight);
        }
      }
      else
        weight = default_edge_weight(mesh, (std::min)(f, g), (std::max)(f, g), v, w);
      energy.gradients[f][i] = (weights.gradient_at(f) + weights.gradient_at(g)) / 2 * weight;
    }
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

  if(solver.arrays().mesh().virtual_vertices.size() > 0)
    return error_non_triangular_mesh;

  const bool parallel = solver.arrays().system.parallel;
  const Dual_graph dual(solver.arrays().system.mesh, parallel);
  Signal signal;
  if(const Error_code code = read_face_signal(solver, in, signal))
    return code;
  Face_energy energy;
  if(const Error_code code = read_face_energy(solver, surface, dual, np, energy))
    return code;
  {
    Stage_scope stage(solver.progress(), Stage::SOLVE);
    if(const Error_code code = filter_face_signal(dual, std::move(energy), parallel, solver.progress(), signal))
      return code;
  }
  return write_face_signal(solver, signal, out);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FACE_SIGNALS_H
