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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_PROCESS_FACE_SIGNAL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_PROCESS_FACE_SIGNAL_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/face_signals.h>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * filters a signal on the faces of a mesh, such as normals or colors: finds the \f$ g \f$ that minimizes
 *
 * \f[ \alpha \sum_f a_f |f_f - g_f|^2 + \beta \sum_e w_e |\lambda (f_a - f_b) - (g_a - g_b)|^2 \f]
 *
 * with the areas \f$ a_f \f$ of the faces and a weight \f$ w_e \f$ for every edge \f$ e \f$ between two faces \f$ a, b
 * \f$: equation 1 of the paper with the graph Laplacian of the dual mesh in place of the stiffness matrix. `denoise()`
 * filters normals in this way. Faces may be polygons; an edge with three faces or more connects none of them.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam InMap a model of `ReadablePropertyMap` with key `face_descriptor` and any value that `Signal_traits` knows
 * \tparam OutMap a model of `WritablePropertyMap` with a value of the same dimension
 *
 * \param tm the mesh; it is not changed
 * \param in the signal \f$ f \f$
 * \param out the result \f$ g \f$; may be `in`
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `area_normalization`,
 *        `face_gradient_weight_map`, `face_gradient_scale_map`, `concurrency_tag`, `visitor`, `vertex_point_map`,
 *        `vertex_index_map` of `Gradient_domain_solver`, and
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
 *     \cgalParamDefault{the length of the edge divided by the distance of the centers of its faces, which makes \f$ \beta \f$ a diffusion time}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return `ok`; or what is wrong, and then `out` is as it was
 */
template <class TriangleMesh, class InMap, class OutMap, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_mesh<TriangleMesh> >
Error_code process_face_signal(const TriangleMesh& tm, InMap in, OutMap out,
                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::process_face_signal(
    make_gradient_domain_solver(tm, parameters::with(np).curvature_metric_kind(Curvature_metric_kind::EMBEDDING)), tm,
    in, out, np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so to a region of the mesh: its faces are all there is, and nothing flows across its border. The values of other
 * faces stay.
 *
 * \param region a range of `face_descriptor`; may be empty
 * \param tm, in, out, np as above
 */
template <class FaceRange, class TriangleMesh, class InMap, class OutMap, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_mesh<TriangleMesh>, class = internal::Enable_if_range<const FaceRange> >
Error_code process_face_signal(const FaceRange& region, const TriangleMesh& tm, InMap in, OutMap out,
                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::process_face_signal(
    make_gradient_domain_solver(region, tm,
                                parameters::with(np).curvature_metric_kind(Curvature_metric_kind::EMBEDDING)),
    tm, in, out, np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so to points and polygons. Property maps have indices, of type `std::size_t`, as keys; there is no
 * `interior_edge_weight_map`, and with `weld_tolerance` faces are neighbors across a seam.
 */
template <class PointRange, class PolygonRange, class InMap, class OutMap, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_range<const PointRange>, class = internal::Enable_if_range<const PolygonRange>,
          class = void>
Error_code process_face_signal(const PointRange& points, const PolygonRange& polygons, InMap in, OutMap out,
                               const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::process_face_signal(
    make_gradient_domain_solver(points, polygons,
                                parameters::with(np).curvature_metric_kind(Curvature_metric_kind::EMBEDDING)),
    polygons, in, out, np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so to a region of points and polygons.
 *
 * \param region a range of indices of polygons; may be empty
 * \param points, polygons, in, out, np as above
 */
template <class FaceRange, class PointRange, class PolygonRange, class InMap, class OutMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_range<const PointRange>,
          class = internal::Enable_if_range<const PolygonRange> >
Error_code process_face_signal(const FaceRange& region, const PointRange& points, const PolygonRange& polygons,
                               InMap in, OutMap out, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::process_face_signal(
    make_gradient_domain_solver(region, points, polygons,
                                parameters::with(np).curvature_metric_kind(Curvature_metric_kind::EMBEDDING)),
    polygons, in, out, np);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_PROCESS_FACE_SIGNAL_H
