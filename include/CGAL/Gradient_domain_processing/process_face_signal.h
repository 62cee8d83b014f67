// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_PROCESS_FACE_SIGNAL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_PROCESS_FACE_SIGNAL_H

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Face_system.h>

#include <cmath>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {

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
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `area_normalization`, `sparse_linear_solver`,
 *        `concurrency_tag`, `visitor`, `vertex_point_map`, `vertex_index_map` of `Gradient_domain_solver`, and
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
template <class TriangleMesh, class InMap, class OutMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code process_face_signal(const TriangleMesh& tm, InMap in, OutMap out, const CGAL_NP_CLASS& np = parameters::default_values())
{
  namespace tag = CGAL::internal_np;
  typedef internal::Parameter_type<tag::sparse_linear_solver_t, CGAL_NP_CLASS, Default_sparse_linear_solver> Linear_solver_type;
  typedef Signal_traits<typename boost::property_traits<InMap>::value_type> In_traits;
  typedef typename boost::property_traits<OutMap>::value_type Out_value;
  typedef Signal_traits<Out_value> Out_traits;
  static_assert(In_traits::dimension == Out_traits::dimension, "input and output have as many channels");

  auto solver = make_gradient_domain_solver(tm, parameters::with(np).curvature_metric_kind(Curvature_metric_kind::EMBEDDING));
  if(solver.error() != OK)
    return solver.error();
  const internal::Indexed_triangles& mesh = solver.system().mesh;
  const internal::Weights& weights = solver.system().weights();
  const auto& faces = solver.elements().faces;
  if(weights.value == 0)
    return ERROR_UNCONSTRAINED;

  internal::Signal signal(mesh.number_of_triangles(), In_traits::dimension);
  std::vector<double> masses(faces.size());
  for(std::size_t f = 0; f < faces.size(); ++f)
  {
    const auto& value = get(in, faces[f]);
    for(int i = 0; i < In_traits::dimension; ++i)
      signal(f, i) = In_traits::channel(value, i);
    if(!signal.row(f).allFinite())
      return solver.invalid_face(ERROR_INVALID_SIGNAL, f);
    masses[f] = weights.value * solver.system().metric(int(f)).area();
    if(masses[f] == 0)
      masses[f] = weights.value; // a face shrunk to a point has no area, but a value
  }

  internal::Face_system<Linear_solver_type> system(internal::parameter(np, tag::sparse_linear_solver, Linear_solver_type()));
  if(const Error_code code = system.analyze(mesh, solver.system().parallel, solver.progress()))
    return code;

  internal::Signal right = internal::Signal::Zero(signal.rows(), signal.cols());
  std::vector<double> edge_weights;
  edge_weights.reserve(system.edges().size());
  const auto center = [&](int f) {
    const auto& t = mesh.triangles[f];
    return internal::Vec3((mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3);
  };
  for(const internal::Interior_edge& e : system.edges())
  {
    double weight;
    if constexpr (internal::Has_parameter<tag::interior_edge_weight_map_t, CGAL_NP_CLASS>::value)
    {
      const auto h = halfedge(solver.elements().vertices[e.from], solver.elements().vertices[e.to], tm).first;
      weight = CGAL::to_double(get(internal::parameter(np, tag::interior_edge_weight_map, 0), edge(h, tm)));
      if(!(weight >= 0) || !std::isfinite(weight))
        return solver.invalid_face(ERROR_INVALID_WEIGHT, std::size_t(e.first));
    }
    else
    {
      const double length = (mesh.points[e.from] - mesh.points[e.to]).norm();
      const double distance = (center(e.first) - center(e.second)).norm();
      weight = length / (std::max)(distance, internal::degeneracy_ratio * (length > 0 ? length : 1.));
    }
    edge_weights.push_back(weights.gradient * weight);
    const auto flow = ((weights.scale - 1) * edge_weights.back() * (signal.row(e.first) - signal.row(e.second))).eval();
    right.row(e.first) += flow;
    right.row(e.second) -= flow;
  }
  if(const Error_code code = system.factorize(masses, edge_weights, solver.progress()))
    return code;
  internal::Signal change;
  if(const Error_code code = system.solve(right, change, solver.progress()))
    return code;

  const internal::Signal result = signal + change;
  std::vector<Out_value> values;
  values.reserve(faces.size());
  for(std::size_t f = 0; f < faces.size(); ++f)
  {
    values.push_back(Out_traits::make(result.row(f).data()));
    for(int i = 0; i < Out_traits::dimension; ++i)
      if(!std::isfinite(Out_traits::channel(values.back(), i)))
        return solver.invalid_face(ERROR_RESULT_OUT_OF_RANGE, f);
  }
  for(std::size_t f = 0; f < faces.size(); ++f)
    put(out, faces[f], values[f]);
  return OK;
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_PROCESS_FACE_SIGNAL_H
