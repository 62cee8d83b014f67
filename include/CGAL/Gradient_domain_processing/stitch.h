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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_STITCH_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_STITCH_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>
#include <CGAL/Gradient_domain_processing/internal/energy/target_field/Seam.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/write_back.h>

#include <map>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {

namespace internal {

// The patches by row, numbered; those of virtual vertices are those of their first corners.
template <class VertexPatchMap, class Surface>
std::vector<int> read_patches(VertexPatchMap map, const Surface_elements<Surface>& elements,
                              const Indexed_triangles& mesh)
{
  std::vector<int> patches;
  std::map<typename boost::property_traits<VertexPatchMap>::value_type, int> numbers;
  for(auto v : elements.vertices)
    patches.push_back(numbers.emplace(get(map, v), int(numbers.size())).first->second);
  for(int k = 0; k < mesh.virtual_vertices.size(); ++k)
    patches.push_back(patches[*mesh.virtual_vertices.corners.begin(k)]);
  return patches;
}

template <class Solver, class VertexPatchMap, class InMap, class OutMap, class NamedParameters>
Error_code stitch(Solver solver, VertexPatchMap patch_map, InMap in, OutMap out, const NamedParameters&)
{
  using namespace CGAL::internal_np;
  if(!Has_parameter<gradient_weight_t, NamedParameters>::value
     && !Has_parameter<face_gradient_weight_map_t, NamedParameters>::value)
    if(const Error_code code = solver.set_gradient_weight(1e4))
      return code;
  if(solver.error() != ok)
    return solver.error();
  auto& filter = solver.arrays();
  const Indexed_triangles& mesh = filter.mesh();
  Signal signal, change;
  if(const Error_code code = solver.checked(read_signal(in, solver.elements(), mesh, false, filter.culprit, signal)))
    return code;
  const std::vector<int> patches = read_patches(patch_map, solver.elements(), mesh);
  if(const Error_code code = filter.solve(Seam(mesh, signal, patches), change))
    return code;
  filter.add(change, signal);
  return solver.checked(write_back(in, signal, out, solver.elements(), filter));
}

} // namespace internal

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * fuses the signals of several patches of a mesh into one without seams, such as the colors of two photographs or the
 * offsets of two scans: the gradients inside each patch are kept, and across a seam none is wanted (paper, sections 1
 * and 2.1; Yu et al. 2004 for positions). On triangles whose vertices belong to different patches the target \f$ v \f$
 * is the part of \f$ \nabla f \f$ along the edge that lies in one patch (zero between three patches), on all others \f$
 * \nabla f \f$. The values \f$ f \f$ determine only what is left open by that, the constants of the patches, by their
 * small weight.
 *
 * A seam across which the signals agree, so that the gradients go on from patch to patch, is left as it is: patches
 * that fit are returned unchanged. They agree where the gradients across the seam differ by less than half (in the mean
 * of squares) from those beside it.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam VertexPatchMap a model of `ReadablePropertyMap` with key `vertex_descriptor` and any value with `operator<`
 * \tparam InMap a model of `ReadablePropertyMap` with key `vertex_descriptor` and any value that `Signal_traits` knows
 * \tparam OutMap a model of `WritablePropertyMap` with a value of the same dimension
 *
 * \param tm the triangle mesh; it is not changed
 * \param patches the patch of every vertex
 * \param in the signal: at every vertex, that of its patch
 * \param out the result; may be `in`
 * \param np all the \ref bgl_namedparameters "Named Parameters" of `Gradient_domain_solver`, of which `gradient_weight`
 *        is by default `1e4`. With constrained vertices, `value_weight(0)` keeps nothing but gradients and constraints.
 *
 * \return `ok`; or what is wrong, and then `out` is as it was
 */
template <class TriangleMesh, class VertexPatchMap, class InMap, class OutMap, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_mesh<TriangleMesh> >
Error_code stitch(const TriangleMesh& tm, VertexPatchMap patches, InMap in, OutMap out,
                  const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::stitch(make_gradient_domain_solver(tm, np), patches, in, out, np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so in a region of the mesh. Vertices that have a face outside of the region keep their values, to the bit, and
 * `out` is written at the vertices of the region only.
 *
 * \param region a range of `face_descriptor`; may be empty
 * \param tm, patches, in, out, np as above
 */
template <class FaceRange, class TriangleMesh, class VertexPatchMap, class InMap, class OutMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_mesh<TriangleMesh>,
          class = internal::Enable_if_range<const FaceRange> >
Error_code stitch(const FaceRange& region, const TriangleMesh& tm, VertexPatchMap patches, InMap in, OutMap out,
                  const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::stitch(make_gradient_domain_solver(region, tm, np), patches, in, out, np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so on a soup, with any number of polygons at an edge. Property maps have indices, of type `std::size_t`, as
 * keys.
 *
 * \param points a model of `RandomAccessContainer` of points
 * \param polygons a model of `RandomAccessContainer` whose value is a range of indices of points
 * \param patches, in, out, np as above
 */
template <class PointRange, class PolygonRange, class VertexPatchMap, class InMap, class OutMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_range<const PointRange>,
          class = internal::Enable_if_range<const PolygonRange>, class = void>
Error_code stitch(const PointRange& points, const PolygonRange& polygons, VertexPatchMap patches, InMap in, OutMap out,
                  const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::stitch(make_gradient_domain_solver(points, polygons, np), patches, in, out, np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so in a region of a soup, a range of indices of polygons.
 */
template <class FaceRange, class PointRange, class PolygonRange, class VertexPatchMap, class InMap, class OutMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_range<const PointRange>,
          class = internal::Enable_if_range<const PolygonRange> >
Error_code stitch(const FaceRange& region, const PointRange& points, const PolygonRange& polygons,
                  VertexPatchMap patches, InMap in, OutMap out, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::stitch(make_gradient_domain_solver(region, points, polygons, np), patches, in, out, np);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_STITCH_H
