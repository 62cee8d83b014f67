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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_PROCESS_SIGNAL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_PROCESS_SIGNAL_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * filters a signal on the vertices of a mesh: finds the \f$ g \f$ that minimizes
 * \f$ \alpha \|f - g\|^2 + \beta \|\lambda \nabla f - \nabla g\|^2 \f$ (paper, equation 1 with \f$ v = \lambda \nabla f
 * \f$). The default smooths (\f$ \lambda = 0 \f$, one implicit step of diffusion); \f$ \lambda > 1 \f$ sharpens. With a
 * curvature metric it is edge-aware or anisotropic.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam InMap a model of `ReadablePropertyMap` with key `vertex_descriptor` and any value that `Signal_traits` knows:
 *         numbers, points, vectors, `CGAL::IO::Color`, arrays, Eigen vectors
 * \tparam OutMap a model of `WritablePropertyMap` with a value of the same dimension
 *
 * \param tm the triangle mesh; it is not changed
 * \param in the signal \f$ f \f$
 * \param out the result \f$ g \f$; may be `in`
 * \param np all the \ref bgl_namedparameters "Named Parameters" of `Gradient_domain_solver`, and
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{how often the filter is applied, to the last result each time; the factorization is shared}
 *     \cgalParamType{`unsigned int`}
 *     \cgalParamDefault{`1`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return `ok`; or what is wrong, and then `out` is as it was
 *
 * \sa `smooth()`
 * \sa `sharpen()`
 */
template <class TriangleMesh, class InMap, class OutMap, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_mesh<TriangleMesh> >
Error_code process_signal(const TriangleMesh& tm, InMap in, OutMap out,
                          const CGAL_NP_CLASS& np = parameters::default_values())
{
  return make_gradient_domain_solver(tm, np).filter(
    in, out, int(internal::parameter(np, CGAL::internal_np::number_of_iterations, 1)));
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so in a region of the mesh. Vertices that have a face outside of the region keep their values, to the bit, and
 * `out` is written at the vertices of the region only.
 *
 * \param region a range of `face_descriptor`; may be empty
 * \param tm, in, out, np as above
 */
template <class FaceRange, class TriangleMesh, class InMap, class OutMap, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_mesh<TriangleMesh>, class = internal::Enable_if_range<const FaceRange> >
Error_code process_signal(const FaceRange& region, const TriangleMesh& tm, InMap in, OutMap out,
                          const CGAL_NP_CLASS& np = parameters::default_values())
{
  return make_gradient_domain_solver(region, tm, np)
    .filter(in, out, int(internal::parameter(np, CGAL::internal_np::number_of_iterations, 1)));
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so on a soup, with any number of polygons at an edge. Property maps have indices, of type `std::size_t`, as
 * keys.
 *
 * \param points a model of `RandomAccessContainer` of points
 * \param polygons a model of `RandomAccessContainer` whose value is a range of indices of points
 * \param in, out, np as above
 */
template <class PointRange, class PolygonRange, class InMap, class OutMap, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_range<const PointRange>, class = internal::Enable_if_range<const PolygonRange>,
          class = void>
Error_code process_signal(const PointRange& points, const PolygonRange& polygons, InMap in, OutMap out,
                          const CGAL_NP_CLASS& np = parameters::default_values())
{
  return make_gradient_domain_solver(points, polygons, np)
    .filter(in, out, int(internal::parameter(np, CGAL::internal_np::number_of_iterations, 1)));
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so in a region of a soup, a range of indices of polygons.
 */
template <class FaceRange, class PointRange, class PolygonRange, class InMap, class OutMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_range<const PointRange>,
          class = internal::Enable_if_range<const PolygonRange> >
Error_code process_signal(const FaceRange& region, const PointRange& points, const PolygonRange& polygons, InMap in,
                          OutMap out, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return make_gradient_domain_solver(region, points, polygons, np)
    .filter(in, out, int(internal::parameter(np, CGAL::internal_np::number_of_iterations, 1)));
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_PROCESS_SIGNAL_H
