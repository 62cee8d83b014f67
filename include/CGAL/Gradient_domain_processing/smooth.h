// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_SMOOTH_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_SMOOTH_H

#include <CGAL/Gradient_domain_processing/internal/filtering/filter_positions.h>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * smooths the positions of a mesh: one implicit step of mean curvature flow (paper, section 2.1, with \f$ \lambda = 0 \f$), or of
 * edge-aware or anisotropic flow with a curvature metric (section 2.3). A sphere of radius \f$ r \f$ shrinks to
 * \f$ r / (1 + 2 t / r^2) \f$, where \f$ t = \beta / \alpha \f$ as a squared length.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, with a vertex point map that can be written
 *
 * \param tm the triangle mesh; its points are moved
 * \param np all the \ref bgl_namedparameters "Named Parameters" of `Gradient_domain_solver`, of which `gradient_scale` is by default `0`, and
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{the number of passes; each starts from the last result and builds its metric anew}
 *     \cgalParamType{`unsigned int`}
 *     \cgalParamDefault{`1`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{restore_volume}
 *     \cgalParamDescription{whether every component is scaled about its centroid so that it encloses the volume it enclosed before. The mesh must be closed and without constraints, else `ERROR_NO_VOLUME` is returned.}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices}
 *     \cgalParamType{a class model of `ReadWritePropertyMap` with key `vertex_descriptor` and a `Point_3` as value}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return `OK`; or what is wrong, and then the mesh is as it was
 *
 * \sa `process_signal()`
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code smooth(TriangleMesh& tm, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::filter_positions(make_gradient_domain_solver(tm, np), tm, 0, np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so to a region of the mesh. Vertices that have a face outside of the region do not move, to the bit. Time and memory are
 * proportional to the region.
 *
 * \param tm the triangle mesh
 * \param region a range of `face_descriptor`; may be empty
 * \param np as above
 */
template <class FaceRange, class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_mesh<TriangleMesh> >
Error_code smooth(const FaceRange& region, TriangleMesh& tm, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::filter_positions(make_gradient_domain_solver(tm, region, np), tm, 0, np);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_SMOOTH_H
