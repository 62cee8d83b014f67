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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_FAIR_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_FAIR_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>
#include <CGAL/Gradient_domain_processing/Hessian_kind.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/move_positions.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/fair_patch.h>

#include <iterator>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {

namespace internal {

// Constrains what is not in the region, beside what the caller has. The middle of a polygon moves with any of its
// corners.
template <class VertexRange, class Solver>
Error_code constrain_outside(const VertexRange& region, Solver& solver)
{
  auto& filter = solver.arrays();
  const Indexed_triangles& mesh = filter.mesh();
  const std::unordered_set<typename Solver::vertex_descriptor> vertices(std::begin(region), std::end(region));
  std::vector<char> is_constrained(mesh.points.size(), 1);
  std::size_t number_found = 0;
  for(int row = 0; row < mesh.number_of_surface_vertices(); ++row)
    if(vertices.count(solver.elements().vertices[std::size_t(row)]) > 0)
    {
      const std::size_t v = std::size_t(mesh.vertex_of(row));
      is_constrained[v] = filter.is_constrained[v];
      ++number_found;
    }
  if(number_found < vertices.size())
    return error_invalid_region;
  for(int k = 0; k < mesh.virtual_vertices.size(); ++k)
    for(const int* row = mesh.virtual_vertices.corners.begin(k); row != mesh.virtual_vertices.corners.end(k); ++row)
      if(!is_constrained[std::size_t(mesh.vertex_of(*row))])
        is_constrained[std::size_t(mesh.first_virtual_vertex() + k)] = 0;
  filter.constrain(std::move(is_constrained));
  return ok;
}

template <class VertexRange, class Solver, class PointMap, class NamedParameters>
Error_code fair_positions(const VertexRange& region, Solver solver, PointMap point_map, const NamedParameters& np)
{
  const int iterations = int(parameter(np, CGAL::internal_np::number_of_iterations, 10));
  if(iterations < 0)
    return error_invalid_parameter;
  if(solver.error() != ok)
    return solver.error();
  if(const Error_code code = constrain_outside(region, solver))
    return code;
  auto& system = solver.arrays().system;
  std::vector<char> is_free;
  for(char is_constrained : system.is_constrained)
    is_free.push_back(!is_constrained);
  return move_positions(solver, point_map, np, [&](const auto& end_of_pass) -> Error_code {
    if(const Error_code code =
         fair_patch(system.mesh, is_free, Hessian_kind::TRACE_FREE_HESSIAN, iterations, 1e-3, system.parallel))
      return code;
    return end_of_pass();
  });
}

} // namespace internal

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * moves the vertices of a region so that the surface goes on smoothly into it from its surroundings: what was there
 * does not count. It turns the flat triangles of a filled hole into a patch without a crease at its border. A hole in a
 * sphere becomes a part of the sphere again, one in a plane a part of the plane.
 *
 * The positions minimize the trace-free part of their squared Hessian, `Hessian_kind::TRACE_FREE_HESSIAN`, under the
 * metric of the surface itself, which is solved a few times, for the metric to follow the shape. The vertices around
 * the region are constrained, and the triangles around them tell the slope.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam VertexRange a range of `vertex_descriptor`
 *
 * \param region the vertices that may move; may be empty
 * \param tm the triangle mesh
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{how often it is solved at most; it ends when no vertex moves by more than a thousandth of the extent of the region}
 *     \cgalParamType{`unsigned int`}
 *     \cgalParamDefault{`10`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_is_constrained_map}
 *     \cgalParamDescription{vertices that stay where they are, to the bit, though they are in the region}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with key `vertex_descriptor` and value `bool`}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices}
 *     \cgalParamType{a class model of `ReadWritePropertyMap` with key `vertex_descriptor` and a `Point_3` as value}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{border_condition}
 *     \cgalParamDescription{whether vertices of the region that are on the border of the mesh may move; `Border_condition::ALONG_BORDER` counts as `Border_condition::FIXED`}
 *     \cgalParamType{`Border_condition`}
 *     \cgalParamDefault{`Border_condition::FREE`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{max_displacement}
 *     \cgalParamDescription{no vertex moves further than this, in the unit of the mesh, at least 0; those that would are held back on their way, and the visitor is told how many}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{no limit}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{movable_axes}
 *     \cgalParamDescription{the axes along which vertices may move, such as `"z"` for a terrain that keeps its grid}
 *     \cgalParamType{a string of the letters `x`, `y` and `z`}
 *     \cgalParamDefault{all}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{weld_tolerance}
 *     \cgalParamDescription{joins border vertices that are not further apart than this, relative to the extent of the surface}
 *     \cgalParamType{`double`, `0` for vertices in the same place, negative for none}
 *     \cgalParamDefault{nothing is welded}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{visitor}
 *     \cgalParamDescription{is told of the stages and may cancel}
 *     \cgalParamType{a model of `GradientDomainVisitor`, or a `std::reference_wrapper` of one}
 *     \cgalParamDefault{`Default_visitor`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_index_map}
 *     \cgalParamDescription{the number of every vertex}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with key `vertex_descriptor` and value `std::size_t`}
 *     \cgalParamDefault{an automatically indexed internal map}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{concurrency_tag}
 *     \cgalParamDescription{whether two or more threads work (with TBB)}
 *     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`}
 *     \cgalParamDefault{`CGAL::Parallel_if_available_tag`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return `ok`; or what is wrong, and then the mesh is as it was: `error_unconstrained` if the region is a component of
 *         the mesh or all but two vertices of one
 */
template <class VertexRange, class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_mesh<TriangleMesh> >
Error_code fair(const VertexRange& region, TriangleMesh& tm, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::fair_positions(region, make_gradient_domain_solver(tm, np), internal::writable_point_map(tm, np),
                                  np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so to a soup, with any number of polygons at an edge.
 *
 * \param region a range of indices of points; may be empty
 * \param points a model of `RandomAccessContainer` of points; they are moved
 * \param polygons a model of `RandomAccessContainer` whose value is a range of indices of points
 * \param np as above; property maps have indices, of type `std::size_t`, as keys
 */
template <class VertexRange, class PointRange, class PolygonRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_range<const PolygonRange> >
Error_code fair(const VertexRange& region, PointRange& points, const PolygonRange& polygons,
                const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::fair_positions(region, make_gradient_domain_solver(points, polygons, np),
                                  internal::writable_point_map(points), np);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_FAIR_H
