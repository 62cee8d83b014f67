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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_SHARPEN_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_SHARPEN_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/filter_positions.h>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * sharpens the positions of a mesh: amplifies their gradients, as unsharp masking does (paper, section 2.1, with
 * \f$ \lambda = 2 \f$). Noise is amplified as well; see `enhance_details()`.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, with a vertex point map that can be written
 *
 * \param tm the triangle mesh; its points are moved
 * \param np all the \ref bgl_namedparameters "Named Parameters" of `smooth()`, of which `gradient_scale` is by default
 *        `2`
 *
 * \return `ok`; or what is wrong, and then the mesh is as it was
 *
 * \sa `process_signal()`
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_mesh<TriangleMesh> >
Error_code sharpen(TriangleMesh& tm, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::filter_positions(make_gradient_domain_solver(tm, np), internal::writable_point_map(tm, np), 2., np);
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
Error_code sharpen(const FaceRange& region, TriangleMesh& tm, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::filter_positions(make_gradient_domain_solver(region, tm, np), internal::writable_point_map(tm, np),
                                    2., np);
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
Error_code sharpen(PointRange& points, const PolygonRange& polygons,
                   const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::filter_positions(make_gradient_domain_solver(points, polygons, np),
                                    internal::writable_point_map(points), 2., np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so to a region of a soup, a range of indices of polygons.
 */
template <class FaceRange, class PointRange, class PolygonRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_range<const PolygonRange> >
Error_code sharpen(const FaceRange& region, PointRange& points, const PolygonRange& polygons,
                   const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::filter_positions(make_gradient_domain_solver(region, points, polygons, np),
                                    internal::writable_point_map(points), 2., np);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_SHARPEN_H
