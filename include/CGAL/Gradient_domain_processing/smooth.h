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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_SMOOTH_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_SMOOTH_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/filter_positions.h>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * smooths the positions of a mesh: one implicit step of mean curvature flow (paper, section 2.1, with \f$ \lambda = 0
 * \f$), or of edge-aware or anisotropic flow with a curvature metric (section 2.3). A sphere of radius \f$ r \f$
 * shrinks to
 * \f$ r / (1 + 2 t / r^2) \f$, where \f$ t = \beta / \alpha \f$ as a squared length.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, with a vertex point map that can be written
 *
 * \param tm the triangle mesh; its points are moved
 * \param np all the \ref bgl_namedparameters "Named Parameters" of `Gradient_domain_solver`, of which `gradient_scale`
 *        is by default `0`, and
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{the number of passes; each starts from the last result and builds its metric anew}
 *     \cgalParamType{`unsigned int`}
 *     \cgalParamDefault{`1`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{restore_volume}
 *     \cgalParamDescription{whether every component is scaled about its centroid so that it encloses the volume it enclosed before. Done after every pass. The mesh must be closed, oriented and without constraints, else `error_no_volume` is returned, as where one collapses.}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices}
 *     \cgalParamType{a class model of `ReadWritePropertyMap` with key `vertex_descriptor` and a `Point_3` as value}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{non_shrinking_order}
 *     \cgalParamDescription{\f$ k \f$: the same factor is applied \f$ k \f$ times to what is still missing, \f$ g_i = g_{i-1} + (\alpha M + \beta S)^{-1} \alpha M (f - g_{i-1}) \f$, which multiplies a wave of the operator's eigenvalue \f$ \mu \f$ by \f$ 1 - (t \mu / (1 + t \mu))^k \f$ with \f$ t = \beta / \alpha \f$. With 2 or more, thin parts keep their girth and spheres their radius; noise is removed a little less. Costs \f$ k \f$ back-substitutions.}
 *     \cgalParamType{`unsigned int`, at least 1}
 *     \cgalParamDefault{`1`}
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
 * \cgalNamedParamsEnd
 *
 * \return `ok`; or what is wrong, and then the mesh is as it was
 *
 * \sa `process_signal()`
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_mesh<TriangleMesh> >
Error_code smooth(TriangleMesh& tm, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::filter_positions(make_gradient_domain_solver(tm, np), internal::writable_point_map(tm, np), 0., np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so to a region of the mesh. Vertices that have a face outside of the region do not move, to the bit. Time and
 * memory are proportional to the region.
 *
 * \param region a range of `face_descriptor`; may be empty
 * \param tm the mesh
 * \param np as above
 */
template <class FaceRange, class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_mesh<TriangleMesh> >
Error_code smooth(const FaceRange& region, TriangleMesh& tm, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::filter_positions(make_gradient_domain_solver(region, tm, np), internal::writable_point_map(tm, np),
                                    0., np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so to a soup, with any number of polygons at an edge.
 *
 * \param points a model of `RandomAccessContainer` of points; they are moved
 * \param polygons a model of `RandomAccessContainer` whose value is a range of indices of points
 * \param np as above; property maps have indices, of type `std::size_t`, as keys
 */
template <class PointRange, class PolygonRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_range<const PolygonRange>, class = void>
Error_code smooth(PointRange& points, const PolygonRange& polygons,
                  const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::filter_positions(make_gradient_domain_solver(points, polygons, np),
                                    internal::writable_point_map(points), 0., np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so to a region of a soup, a range of indices of polygons.
 */
template <class FaceRange, class PointRange, class PolygonRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_range<const PolygonRange> >
Error_code smooth(const FaceRange& region, PointRange& points, const PolygonRange& polygons,
                  const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::filter_positions(make_gradient_domain_solver(region, points, polygons, np),
                                    internal::writable_point_map(points), 0., np);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_SMOOTH_H
