// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_FIT_TO_NORMALS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_FIT_TO_NORMALS_H

#include <CGAL/Gradient_domain_processing/internal/filtering/filter_positions.h>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {

namespace internal {

template <class Solver, class TriangleMesh, class VertexNormalMap, class NamedParameters>
Error_code fit_to_normals(Solver solver, TriangleMesh& tm, VertexNormalMap normal_map, const NamedParameters& np)
{
  using namespace CGAL::internal_np;
  if(solver.error() != OK)
    return solver.error();
  std::vector<Vec3> given;
  if(const Error_code code = solver.read_vectors(normal_map, given))
    return code;
  Signal normals = as_signal(given);
  if(!Has_parameter<gradient_scale_t, NamedParameters>::value && !Has_parameter<face_gradient_scale_map_t, NamedParameters>::value)
    solver.set_gradient_scale(1);

  return change_positions(solver, tm, np, [&]() -> Error_code {
    if(solver.system().weights().scale != 1 || !solver.system().weights().scale_at_face.empty())
      if(const Error_code code = solver.filter_in_place(normals))
        return code;
    if(const Error_code code = solver.set_gradient_weight(parameter(np, normal_projection_weight, 100.)))
      return code;

    // edges shall be orthogonal to the normals at their ends: what of them is not, is too much
    const Indexed_triangles& mesh = solver.system().mesh;
    const auto excess = [&](int f, int i, int j) -> Vec3 {
      const int v = mesh.triangles[f][i], w = mesh.triangles[f][j];
      const Vec3 n = (normals.row(v) + normals.row(w)).transpose();
      const double squared_length = n.squaredNorm();
      return (squared_length > 0 ? -n.dot(mesh.points[w] - mesh.points[v]) / squared_length : 0.) * n;
    };
    Signal change;
    if(const Error_code code = solver.solve(excess, 3, change))
      return code;
    solver.set_points(as_signal(mesh.points) + change);
    return OK;
  });
}

} // namespace internal

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * moves the vertices of a mesh so that its normals agree with given ones (after Yu et al.\ 2004, as in the program of the paper's
 * authors). The normals are first filtered as a signal, with the weights and metric of the parameters, unless
 * \f$ \lambda = 1 \f$. Then every edge \f$ d = p_j - p_i \f$ is asked to be orthogonal to \f$ n = n_i + n_j \f$: its target is
 * \f$ d - \frac{\langle d, n \rangle}{\langle n, n \rangle} n \f$, and the positions that fit these targets best are solved for, with the weight
 * `normal_projection_weight` in place of \f$ \beta \f$.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, with a vertex point map that can be written
 * \tparam VertexNormalMap a model of `ReadablePropertyMap` with key `vertex_descriptor` and a `Vector_3` as value
 *
 * \param tm the triangle mesh; its points are moved
 * \param normals outward normals, used as they are; best of length one
 * \param np all the \ref bgl_namedparameters "Named Parameters" of `smooth()` but `number_of_iterations`, of which `gradient_scale`
 *        is by default `1` (the normals are used as given), and
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{normal_projection_weight}
 *     \cgalParamDescription{how strongly the normals are fitted; a squared length, as `gradient_weight`}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`100`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return `OK`; or what is wrong, and then the mesh is as it was
 */
template <class TriangleMesh, class VertexNormalMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code fit_to_normals(TriangleMesh& tm, VertexNormalMap normals, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::fit_to_normals(make_gradient_domain_solver(tm, np), tm, normals, np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so to a region of the mesh. Vertices that have a face outside of the region do not move, to the bit.
 *
 * \param tm the triangle mesh
 * \param normals outward normals at the vertices of the region
 * \param region a range of `face_descriptor`; may be empty
 * \param np as above
 */
template <class FaceRange, class TriangleMesh, class VertexNormalMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code fit_to_normals(const FaceRange& region, TriangleMesh& tm, VertexNormalMap normals,
                          const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::fit_to_normals(make_gradient_domain_solver(tm, region, np), tm, normals, np);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_FIT_TO_NORMALS_H
