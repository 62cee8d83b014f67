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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_ENHANCE_DETAILS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_ENHANCE_DETAILS_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/move_positions.h>

namespace CGAL {
namespace Gradient_domain_processing {

namespace internal {

// The metric of the second pass: its own, whatever the first had.
template <class Solver, class NamedParameters>
Error_code set_sharpening_metric(Solver& solver, const NamedParameters& np)
{
  using namespace CGAL::internal_np;
  if constexpr (!Has_parameter<sharpening_metric_kind_t, NamedParameters>::value)
    return solver.set_embedding_metric();
  else
    return solver.checked(set_curvature_metric(parameter(np, sharpening_metric_kind, Curvature_metric_kind::EMBEDDING),
                                               parameter(np, sharpening_curvature_weight, 0.02), np, solver.elements(),
                                               solver.arrays()));
}

template <class Solver, class PointMap, class NamedParameters>
Error_code enhance_details(Solver solver, PointMap point_map, const NamedParameters& np)
{
  using namespace CGAL::internal_np;
  return move_positions(solver, point_map, np, [&](const auto& end_of_pass) {
    if(const Error_code code = solver.arrays().filter_points())
      return code;
    if(const Error_code code = end_of_pass())
      return code;
    solver.arrays().set_second_order(0, Hessian_kind::SQUARED_HESSIAN);
    if(const Error_code code = set_sharpening_metric(solver, np))
      return code;
    if(const Error_code code = solver.set_gradient_weight(parameter(np, sharpening_weight, 1e-5)))
      return code;
    if(const Error_code code = solver.set_gradient_scale(parameter(np, sharpening_scale, 4.)))
      return code;
    if(const Error_code code = solver.arrays().filter_points())
      return code;
    return end_of_pass();
  });
}

} // namespace internal

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * enhances the details of a noisy mesh in two passes: the first smooths the noise away, the second sharpens what is
 * left with a narrower filter (paper, section 2.4 and Figure 4). The passes share order and symbolic factorization.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, with a vertex point map that can be written
 *
 * \param tm the triangle mesh; its points are moved
 * \param np all the \ref bgl_namedparameters "Named Parameters" of `smooth()` but `number_of_iterations`: they describe
 *        the first pass, which an edge-aware metric makes keep sharp details (constraints and `vertex_value_weight_map`
 *        hold for both passes, `face_gradient_weight_map` and `face_gradient_scale_map` for the first); and
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{sharpening_weight}
 *     \cgalParamDescription{\f$ \beta \f$ of the second pass; as `gradient_weight`. Should be less than that of the first, whose noise it would amplify otherwise.}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`1e-5`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{sharpening_scale}
 *     \cgalParamDescription{\f$ \lambda \f$ of the second pass; useful: 2 to 8}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`4`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{sharpening_metric_kind}
 *     \cgalParamDescription{the metric of the second pass, as `curvature_metric_kind`; estimated on the result of the first}
 *     \cgalParamType{`Curvature_metric_kind`, or a functor model of `CurvatureStretch`}
 *     \cgalParamDefault{`Curvature_metric_kind::EMBEDDING`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{sharpening_curvature_weight}
 *     \cgalParamDescription{\f$ \epsilon \f$ of the second pass, as `curvature_weight`}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`0.02`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return `ok`; or what is wrong, and then the mesh is as it was
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_mesh<TriangleMesh> >
Error_code enhance_details(TriangleMesh& tm, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::enhance_details(make_gradient_domain_solver(tm, np), internal::writable_point_map(tm, np), np);
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
Error_code enhance_details(const FaceRange& region, TriangleMesh& tm,
                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::enhance_details(make_gradient_domain_solver(region, tm, np), internal::writable_point_map(tm, np),
                                   np);
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
Error_code enhance_details(PointRange& points, const PolygonRange& polygons,
                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::enhance_details(make_gradient_domain_solver(points, polygons, np),
                                   internal::writable_point_map(points), np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so to a region of a soup, a range of indices of polygons.
 */
template <class FaceRange, class PointRange, class PolygonRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_range<const PolygonRange> >
Error_code enhance_details(const FaceRange& region, PointRange& points, const PolygonRange& polygons,
                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::enhance_details(make_gradient_domain_solver(region, points, polygons, np),
                                   internal::writable_point_map(points), np);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_ENHANCE_DETAILS_H
