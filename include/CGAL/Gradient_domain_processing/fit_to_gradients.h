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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_FIT_TO_GRADIENTS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_FIT_TO_GRADIENTS_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * finds the signal \f$ g \f$ whose gradients are closest to given ones: minimizes
 * \f$ \alpha \|f - g\|^2 + \beta \|v - \nabla g\|^2 \f$ (paper, equation 1) for any target field \f$ v \f$. With
 * constrained vertices and `value_weight(0)` it is the Poisson problem with Dirichlet conditions.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam InMap a model of `ReadablePropertyMap` with key `vertex_descriptor` and any value that `Signal_traits` knows
 * \tparam FaceGradientMap a model of `ReadablePropertyMap` with key `face_descriptor` whose value is a range of as many
 *         `Vector_3` as the signal has channels, such as `std::array<Vector_3, 1>` for numbers and
 *         `std::array<Vector_3, 3>` for points
 * \tparam OutMap a model of `WritablePropertyMap` with a value of the same dimension as the input
 *
 * \param tm the triangle mesh; it is not changed
 * \param in the signal \f$ f \f$; at constrained vertices, their values
 * \param gradients the target \f$ v \f$, one vector for every face and channel, in units of the signal per length. The
 *        gradient of a function that is linear on the face is the vector in its plane whose inner product with every
 *        edge is the difference along it; a normal part is ignored.
 * \param out the result \f$ g \f$; may be `in`
 * \param np all the \ref bgl_namedparameters "Named Parameters" of `Gradient_domain_solver`, of which `gradient_scale`
 *        has no meaning here
 *
 * \return `ok`; or what is wrong, and then `out` is as it was
 */
template <class TriangleMesh, class InMap, class FaceGradientMap, class OutMap, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_mesh<TriangleMesh> >
Error_code fit_to_gradients(const TriangleMesh& tm, InMap in, FaceGradientMap gradients, OutMap out,
                            const CGAL_NP_CLASS& np = parameters::default_values())
{
  return make_gradient_domain_solver(tm, np).fit_to_gradients(in, gradients, out);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so in a region of the mesh. Vertices that have a face outside of the region keep their values, to the bit, and
 * `out` is written at the vertices of the region only.
 *
 * \param region a range of `face_descriptor`; may be empty
 * \param tm, in, gradients, out, np as above
 */
template <class FaceRange, class TriangleMesh, class InMap, class FaceGradientMap, class OutMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_mesh<TriangleMesh>,
          class = internal::Enable_if_range<const FaceRange> >
Error_code fit_to_gradients(const FaceRange& region, const TriangleMesh& tm, InMap in, FaceGradientMap gradients,
                            OutMap out, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return make_gradient_domain_solver(region, tm, np).fit_to_gradients(in, gradients, out);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so on a soup, with any number of polygons at an edge. Property maps have indices, of type `std::size_t`, as
 * keys.
 *
 * \param points a model of `RandomAccessContainer` of points
 * \param polygons a model of `RandomAccessContainer` whose value is a range of indices of points
 * \param in, gradients, out, np as above
 */
template <class PointRange, class PolygonRange, class InMap, class FaceGradientMap, class OutMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_range<const PointRange>,
          class = internal::Enable_if_range<const PolygonRange>, class = void>
Error_code fit_to_gradients(const PointRange& points, const PolygonRange& polygons, InMap in, FaceGradientMap gradients,
                            OutMap out, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return make_gradient_domain_solver(points, polygons, np).fit_to_gradients(in, gradients, out);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so in a region of a soup, a range of indices of polygons.
 */
template <class FaceRange, class PointRange, class PolygonRange, class InMap, class FaceGradientMap, class OutMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_range<const PointRange>,
          class = internal::Enable_if_range<const PolygonRange> >
Error_code fit_to_gradients(const FaceRange& region, const PointRange& points, const PolygonRange& polygons, InMap in,
                            FaceGradientMap gradients, OutMap out,
                            const CGAL_NP_CLASS& np = parameters::default_values())
{
  return make_gradient_domain_solver(region, points, polygons, np).fit_to_gradients(in, gradients, out);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_FIT_TO_GRADIENTS_H
