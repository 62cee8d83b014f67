// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_PROCESS_FACE_SIGNAL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_PROCESS_FACE_SIGNAL_H

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/filter_face_signal.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
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
        return solver.invalid_face(ERROR_INVALID_SIGNAL, f);
    }
  }
  return OK;
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
        return solver.invalid_face(ERROR_RESULT_OUT_OF_RANGE, f);
  }
  for(std::size_t f = 0; f < faces.size(); ++f)
    put(out, faces[f], values[f]);
  return OK;
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

template <class Solver, class TriangleMesh, class NamedParameters>
Error_code read_face_energy(Solver& solver, const TriangleMesh& tm, const Dual_graph& dual, const NamedParameters& np, Face_energy& energy)
{
  namespace tag = CGAL::internal_np;
  const Indexed_triangles& mesh = solver.system().mesh;
  const Weights& weights = solver.system().weights();
  const std::size_t n = mesh.triangles.size();
  energy.values.resize(n);
  energy.scales.resize(n);
  energy.gradients.assign(n, {{0, 0, 0}});
  for(int f = 0; f < dual.size(); ++f)
  {
    const double area = solver.system().metric(f).area();
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
        const auto h = halfedge(solver.elements().vertices[v], solver.elements().vertices[w], tm).first;
        weight = CGAL::to_double(get(parameter(np, tag::interior_edge_weight_map, 0), edge(h, tm)));
        if(!(weight >= 0) || !std::isfinite(weight))
          return solver.invalid_face(ERROR_INVALID_WEIGHT, std::size_t(f));
      }
      else
        weight = default_edge_weight(mesh, (std::min)(f, g), (std::max)(f, g), v, w);
      energy.gradients[f][i] = (weights.gradient_at(f) + weights.gradient_at(g)) / 2 * weight;
    }
  }
  return OK;
}

template <class Solver, class TriangleMesh, class InMap, class OutMap, class NamedParameters>
Error_code process_face_signal(Solver solver, const TriangleMesh& tm, InMap in, OutMap out, const NamedParameters& np)
{
  typedef Signal_traits<typename boost::property_traits<InMap>::value_type> In_traits;
  typedef Signal_traits<typename boost::property_traits<OutMap>::value_type> Out_traits;
  static_assert(In_traits::dimension == Out_traits::dimension, "input and output have as many channels");
  if(solver.error() != OK)
    return solver.error();
  if(solver.system().weights().value == 0)
    return ERROR_UNCONSTRAINED;

  const bool parallel = solver.system().parallel;
  const Dual_graph dual(solver.system().mesh, parallel);
  Signal signal;
  if(const Error_code code = read_face_signal(solver, in, signal))
    return code;
  Face_energy energy;
  if(const Error_code code = read_face_energy(solver, tm, dual, np, energy))
    return code;
  {
    Stage_scope stage(solver.progress(), Stage::SOLVE);
    if(const Error_code code = filter_face_signal(dual, std::move(energy), parallel, solver.progress(), signal))
      return code;
  }
  return write_face_signal(solver, signal, out);
}

} // namespace internal

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * filters a signal on the faces of a mesh, such as normals or colors: finds the \f$ g \f$ that minimizes
 *
 * \f[ \alpha \sum_f a_f |f_f - g_f|^2 + \beta \sum_e w_e |\lambda (f_a - f_b) - (g_a - g_b)|^2 \f]
 *
 * with the areas \f$ a_f \f$ of the faces and a weight \f$ w_e \f$ for every edge \f$ e \f$ between two faces \f$ a, b \f$: equation 1 of the
 * paper with the graph Laplacian of the dual mesh in place of the stiffness matrix. `denoise()` filters normals in this way.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam InMap a model of `ReadablePropertyMap` with key `face_descriptor` and any value that `Signal_traits` knows
 * \tparam OutMap a model of `WritablePropertyMap` with a value of the same dimension
 *
 * \param tm the triangle mesh; it is not changed
 * \param in the signal \f$ f \f$
 * \param out the result \f$ g \f$; may be `in`
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `area_normalization`,
 *        `face_gradient_weight_map`, `face_gradient_scale_map`, `concurrency_tag`, `visitor`, `vertex_point_map`, `vertex_index_map` of `Gradient_domain_solver`, and
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{value_weight}
 *     \cgalParamDescription{\f$ \alpha \f$, more than 0}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`1`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{gradient_weight}
 *     \cgalParamDescription{\f$ \beta \f$, at least 0. A squared length, relative to the area of the mesh as `area_normalization` says.}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`1e-4`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{gradient_scale}
 *     \cgalParamDescription{\f$ \lambda \f$: below 1 smooths, above 1 sharpens}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`0`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{interior_edge_weight_map}
 *     \cgalParamDescription{\f$ w_e \f$ at every edge that is not a border edge, at least 0 and without unit; for example small where the signal may jump}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with key `edge_descriptor` and a number type as value}
 *     \cgalParamDefault{the length of the edge divided by the distance of the centroids of its faces, which makes \f$ \beta \f$ a diffusion time}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return `OK`; or what is wrong, and then `out` is as it was
 */
template <class TriangleMesh, class InMap, class OutMap, typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_mesh<OutMap> >
Error_code process_face_signal(const TriangleMesh& tm, InMap in, OutMap out, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::process_face_signal(
    make_gradient_domain_solver(tm, parameters::with(np).curvature_metric_kind(Curvature_metric_kind::EMBEDDING)), tm, in, out, np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so to a region of the mesh: its faces are all there is, and nothing flows across its border. The values of other faces stay.
 *
 * \param region a range of `face_descriptor`; may be empty
 * \param tm the triangle mesh
 * \param in the signal
 * \param out the result
 * \param np as above
 */
template <class FaceRange, class TriangleMesh, class InMap, class OutMap, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_mesh<OutMap> >
Error_code process_face_signal(const FaceRange& region, const TriangleMesh& tm, InMap in, OutMap out,
                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::process_face_signal(
    make_gradient_domain_solver(tm, region, parameters::with(np).curvature_metric_kind(Curvature_metric_kind::EMBEDDING)), tm, in, out, np);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_PROCESS_FACE_SIGNAL_H
