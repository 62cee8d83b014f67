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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_ESTIMATE_CURVATURES_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_ESTIMATE_CURVATURES_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * The principal curvatures and directions at a vertex, with the members of
 * `CGAL::Polygon_mesh_processing::Principal_curvatures_and_directions` (CGAL 6). Curvatures are in 1/length and
 * positive where the surface is convex; directions are of length one and orthogonal.
 *
 * \tparam GeomTraits a model of `Kernel`
 */
template <class GeomTraits>
struct Principal_curvatures_and_directions
{
  typename GeomTraits::FT min_curvature; ///< the smaller principal curvature
  typename GeomTraits::FT max_curvature; ///< the larger principal curvature
  typename GeomTraits::Vector_3 min_direction; ///< the direction of the smaller
  typename GeomTraits::Vector_3 max_direction; ///< the direction of the larger
};

namespace internal {

template <class Solver, class VertexCurvatureMap, class NamedParameters>
Error_code estimate_curvatures(Solver solver, VertexCurvatureMap curvatures, const NamedParameters& np)
{
  typedef typename boost::property_traits<VertexCurvatureMap>::value_type Curvature;

  if(solver.error() != ok)
    return solver.error();
  auto& filter = solver.arrays();
  Curvature_options options;
  if(const Error_code code = solver.checked(read_curvature_options(np, solver.elements(), filter, 0., options)))
    return code;
  std::vector<Principal_curvatures> found;
  if(const Error_code code = filter.estimate_by_jets(options, found))
    return code;

  typedef decltype(Curvature::min_curvature) FT;
  typedef decltype(Curvature::min_direction) Vector_3;
  const Indexed_triangles& mesh = filter.mesh();
  const auto vector = [](const Vec3& v) { return Vector_3(FT(v[0]), FT(v[1]), FT(v[2])); };
  std::vector<Curvature> result;
  for(int row = 0; row < mesh.number_of_surface_vertices(); ++row)
  {
    const Principal_curvatures& k = found[mesh.vertex_of(row)];
    result.push_back(Curvature{FT(k.min_curvature / mesh.unit()), FT(k.max_curvature / mesh.unit()),
                               vector(k.min_direction), vector(k.max_direction)});
    if(!std::isfinite(CGAL::to_double(result.back().min_curvature))
       || !std::isfinite(CGAL::to_double(result.back().max_curvature)))
    {
      filter.culprit.row = row;
      return solver.checked(error_result_out_of_range);
    }
  }
  for(std::size_t row = 0; row < result.size(); ++row)
    put(curvatures, solver.elements().vertices[row], result[row]);
  return ok;
}

} // namespace internal

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * estimates principal curvatures and directions at the vertices of a mesh by `CGAL::Monge_via_jet_fitting`. The points
 * around a vertex are gathered ring by ring until there are enough for the degree; the result is oriented by the
 * normals of the mesh, so that convex is positive. Where nothing can be fitted (a vertex without a face, collinear or
 * coincident neighbors), the curvature is zero.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam VertexCurvatureMap a model of `WritablePropertyMap` with key `vertex_descriptor` and a value type that can be
 *         made from min_curvature, max_curvature, min_direction, max_direction in braces, such as
 *         `Principal_curvatures_and_directions` here and in CGAL 6
 *
 * \param tm the triangle mesh; it is not changed
 * \param curvatures the result
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `jet_degree`,
 *        `presmoothing_weight` (by default `0` here: curvature of the mesh as it is), `area_normalization`,
 *        `vertex_normal_map`, `concurrency_tag`, `visitor`, `sparse_linear_solver`, `vertex_point_map`,
 *        `vertex_index_map` of `Gradient_domain_solver`
 *
 * \return `ok`; or what is wrong, and then `curvatures` is as it was
 *
 * Complexity: proportional to the number of vertices, with TBB in parallel; results do not depend on the number of
 * threads.
 */
template <class TriangleMesh, class VertexCurvatureMap, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_mesh<TriangleMesh> >
Error_code estimate_curvatures(const TriangleMesh& tm, VertexCurvatureMap curvatures,
                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::estimate_curvatures(
    make_gradient_domain_solver(tm, parameters::with(np).curvature_metric_kind(Curvature_metric_kind::EMBEDDING)),
    curvatures, np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so for a soup of points and polygons. The keys of `curvatures` are indices of points, of type `std::size_t`.
 */
template <class PointRange, class PolygonRange, class VertexCurvatureMap, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_range<const PointRange>, class = internal::Enable_if_range<const PolygonRange> >
Error_code estimate_curvatures(const PointRange& points, const PolygonRange& polygons, VertexCurvatureMap curvatures,
                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::estimate_curvatures(
    make_gradient_domain_solver(points, polygons,
                                parameters::with(np).curvature_metric_kind(Curvature_metric_kind::EMBEDDING)),
    curvatures, np);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_ESTIMATE_CURVATURES_H
