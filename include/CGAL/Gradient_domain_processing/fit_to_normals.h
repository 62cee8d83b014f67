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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_FIT_TO_NORMALS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_FIT_TO_NORMALS_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>
#include <CGAL/Gradient_domain_processing/internal/energy/target_field/Normal_fit.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/counted.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/move_positions.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/own_normals.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/offset_to_volumes.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {

namespace internal {

template <class Solver, class PointMap, class VertexNormalMap, class NamedParameters>
Error_code fit_to_normals(Solver solver, PointMap point_map, VertexNormalMap normal_map, const NamedParameters& np)
{
  using namespace CGAL::internal_np;
  if(solver.error() != ok)
    return solver.error();
  auto& filter = solver.arrays();
  const Indexed_triangles& mesh = filter.mesh();
  Signal wanted, own;
  if(const Error_code code = solver.checked(read_vectors(normal_map, solver.elements(), mesh, filter.culprit, wanted)))
    return code;
  if(const Error_code code = solver.checked(read_own_normals(np, solver.elements(), filter, own)))
    return code;
  if(!Has_parameter<gradient_scale_t, NamedParameters>::value
     && !Has_parameter<face_gradient_scale_map_t, NamedParameters>::value)
    filter.system.set_scale(1);

  const Normal_fit_kind kind = parameter(np, normal_fit_kind, Normal_fit_kind::FACES);
  return move_positions(solver, point_map, np, [&](const auto& end_of_pass) -> Error_code {
    if(filter.system.weights().scale != 1 || !filter.system.weights().scale_at_triangle.empty())
      if(const Error_code code = filter.filter(wanted))
        return code;
    if(const Error_code code = solver.set_gradient_weight(parameter(np, normal_projection_weight, 100.)))
      return code;
    Signal change;
    if(const Error_code code = filter.solve(Normal_fit(mesh, own, wanted, kind), change))
      return code;
    const std::vector<Vec3> before = mesh.points;
    filter.move_points(change);
    if(kind == Normal_fit_kind::FACES && filter.encloses_volume()
       && read_position_options(np, false).moves_along_all_axes())
      if(const int count = offset_to_volumes(mesh, before, filter.system.parallel, filter.system.mesh.points))
        solver.progress().notice(counted(std::size_t(count), "component encloses", "components enclose")
                                 + " another volume than before");
    return end_of_pass();
  });
}

} // namespace internal

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * moves the vertices of a mesh so that its normals agree with given ones. The normals are first filtered as a signal,
 * with the weights and metric of the parameters, unless \f$ \lambda = 1 \f$. Then positions are solved for whose
 * gradients fit the target
 * \f$ v = (I - m m^T) \nabla x \f$ best, with the weight `normal_projection_weight` in place of \f$ \beta \f$. The
 * normal \f$ m \f$ wanted of a face is its own, turned by the rotation that takes the mean of the mesh's vertex normals
 * at its corners to that of the wanted ones: the mesh's own normals move nothing, at creases and corners either. Where
 * the wanted normals differ from the mesh's by as much as the face does from the mean at its corners, that mean of the
 * wanted ones is taken instead. Normals determine a closed surface up to an offset only, for parallel surfaces have the
 * same; of these it is the one that encloses the volume the component enclosed before, where the mesh is closed and has
 * no constraints. The vertex normals of the mesh are its `vertex_normal_map` if one is named, else the normalized sums
 * of area-weighted face normals.
 *
 * With `normal_fit_kind(Normal_fit_kind::EDGES)`, as in the program of the paper's authors (after Yu et al.\ 2004),
 * every edge
 * \f$ d = p_j - p_i \f$ is asked to be orthogonal to the sum \f$ n = n_i + n_j \f$ instead, by the target
 * \f$ d - \frac{\langle d, n \rangle}{\langle n, n \rangle} n \f$.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, with a vertex point map that can be written
 * \tparam VertexNormalMap a model of `ReadablePropertyMap` with key `vertex_descriptor` and a `Vector_3` as value
 *
 * \param tm the triangle mesh; its points are moved
 * \param normals outward normals, used as they are; best of length one
 * \param np all the \ref bgl_namedparameters "Named Parameters" of `smooth()` but `number_of_iterations`, of which
 *        `gradient_scale` is by default `1` (the normals are used as given), and
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{normal_projection_weight}
 *     \cgalParamDescription{how strongly the normals are fitted; a squared length, as `gradient_weight`}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`100`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{normal_fit_kind}
 *     \cgalParamDescription{how normals are asked for}
 *     \cgalParamType{`Normal_fit_kind`}
 *     \cgalParamDefault{`Normal_fit_kind::FACES`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return `ok`; or what is wrong, and then the mesh is as it was
 */
template <class TriangleMesh, class VertexNormalMap, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_mesh<TriangleMesh> >
Error_code fit_to_normals(TriangleMesh& tm, VertexNormalMap normals,
                          const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::fit_to_normals(make_gradient_domain_solver(tm, np), internal::writable_point_map(tm, np), normals,
                                  np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so to a region of the mesh. Vertices that have a face outside of the region do not move, to the bit.
 *
 * \param region a range of `face_descriptor`; may be empty
 * \param tm the mesh
 * \param normals outward normals
 * \param np as above
 */
template <class FaceRange, class TriangleMesh, class VertexNormalMap, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_mesh<TriangleMesh> >
Error_code fit_to_normals(const FaceRange& region, TriangleMesh& tm, VertexNormalMap normals,
                          const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::fit_to_normals(make_gradient_domain_solver(region, tm, np), internal::writable_point_map(tm, np),
                                  normals, np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so to a soup, with any number of polygons at an edge.
 *
 * \param points a model of `RandomAccessContainer` of points; they are moved
 * \param polygons a model of `RandomAccessContainer` whose value is a range of indices of points
 * \param normals outward normals
 * \param np as above; property maps have indices, of type `std::size_t`, as keys
 */
template <class PointRange, class PolygonRange, class VertexNormalMap, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_range<const PolygonRange>, class = void>
Error_code fit_to_normals(PointRange& points, const PolygonRange& polygons, VertexNormalMap normals,
                          const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::fit_to_normals(make_gradient_domain_solver(points, polygons, np),
                                  internal::writable_point_map(points), normals, np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so to a region of a soup, a range of indices of polygons.
 */
template <class FaceRange, class PointRange, class PolygonRange, class VertexNormalMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_range<const PolygonRange> >
Error_code fit_to_normals(const FaceRange& region, PointRange& points, const PolygonRange& polygons,
                          VertexNormalMap normals, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::fit_to_normals(make_gradient_domain_solver(region, points, polygons, np),
                                  internal::writable_point_map(points), normals, np);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_FIT_TO_NORMALS_H
