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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_DENOISE_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_DENOISE_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/Denoising_summary.h>
#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/denoise_positions.h>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * removes noise from the positions of a mesh and keeps its creases, without a parameter to choose:
 * - outliers, vertices far outside of where their neighbors are at the scale of those, go to where these are, and their
 *   input position gets no weight;
 * - the noise is measured, for every component of the mesh alone: white noise by its share in the roughness, and noise
 *   that is correlated from vertex to vertex, as of depth cameras and label maps, by what a fine smoothing takes away;
 * - the face normals, a signal on the faces, are filtered by a Laplacian of the dual mesh whose weights fall with the
 *   distance of neighboring normals (Geman and McClure's function; twice a pass). The distance \f$ \sigma \f$ that
 *   counts as similar and the weight \f$ \beta \f$ of the smoothing follow from the noise; \f$ \beta \f$ grows with the
 *   square of its scale;
 * - the positions are fitted by equation 1 of the paper, under the metric of equilateral triangles, with the values of
 *   the noisy input and the target \f$ v = (I - n n^T) \nabla x \f$, the tangential part of the current gradients. So
 *   vertices do not slide;
 * - what was taken away and goes on from vertex to vertex is detail: it is given back where it is stronger than noise
 *   would be.
 *
 * The passes go on while what they remove looks like noise, 20 times at most; where no flat pieces between creases have
 * come out after 8 or 9 passes and normals have settled, the surface is smooth and they end. After the fifth pass the
 * faces at a border stay as they are. A clean mesh is returned as it is: its roughness is not taken for noise where
 * neighboring vertices stand out together, or lie in the planes of larger facets. Where any of the parameters below is
 * named for such a mesh, it is obeyed.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`, with a vertex point map that can be written
 *
 * \param tm the triangle mesh; its points are moved
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `vertex_is_constrained_map`,
 *        `border_condition`, `non_manifold_condition`, `concurrency_tag`, `visitor`, `vertex_point_map`,
 *        `vertex_index_map` of `Gradient_domain_solver`, and
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_iterations}
 *     \cgalParamDescription{the number of passes: about 5 to 9 suit smooth scans, 15 to 20 creased parts}
 *     \cgalParamType{`unsigned int`}
 *     \cgalParamDefault{chosen from the data, at most 20}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{noise_level}
 *     \cgalParamDescription{the noise of the face normals, in radians; 0 to 1}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{estimated}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{noise_scale}
 *     \cgalParamDescription{over how many mean edge lengths the noise is correlated; 1 for white noise; useful: 1 to 9. More smooths further, at the same difference of normals.}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{1 for white noise, 6 where correlated noise is found, 1.4 where neither is and a level or a number of passes is named}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{value_weight}
 *     \cgalParamDescription{how strongly the input positions are kept; useful: 0.02 (smoother, vertices move more) to 0.1}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{`0.045`, divided by the scale of the noise}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{denoising_summary}
 *     \cgalParamDescription{what was found and done}
 *     \cgalParamType{`std::reference_wrapper<Denoising_summary>`}
 *     \cgalParamDefault{not told}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{restore_volume}
 *     \cgalParamDescription{whether the enclosed volume of every component is restored}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`true` where the mesh is closed, oriented and has no constraint}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return `ok`; or what is wrong, and then the mesh is as it was
 *
 * Complexity: a pass solves for the normals twice and for the positions three times, by conjugate gradients from the
 * last solution, some 5 to 30 steps each; all of it is linear and parallel, and gives the same bits on any number of
 * threads.
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_mesh<TriangleMesh> >
Error_code denoise(TriangleMesh& tm, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::denoise_positions(make_gradient_domain_solver(tm, np), internal::writable_point_map(tm, np), np);
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
Error_code denoise(const FaceRange& region, TriangleMesh& tm, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::denoise_positions(make_gradient_domain_solver(region, tm, np), internal::writable_point_map(tm, np),
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
Error_code denoise(PointRange& points, const PolygonRange& polygons,
                   const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::denoise_positions(make_gradient_domain_solver(points, polygons, np),
                                     internal::writable_point_map(points), np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so to a region of a soup, a range of indices of polygons.
 */
template <class FaceRange, class PointRange, class PolygonRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_range<const PolygonRange> >
Error_code denoise(const FaceRange& region, PointRange& points, const PolygonRange& polygons,
                   const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::denoise_positions(make_gradient_domain_solver(region, points, polygons, np),
                                     internal::writable_point_map(points), np);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_DENOISE_H
