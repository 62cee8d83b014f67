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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_MAKE_GRADIENT_DOMAIN_SOLVER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_MAKE_GRADIENT_DOMAIN_SOLVER_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * returns a `Gradient_domain_solver` for the mesh, with the linear solver that is named in `np`.
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_mesh<TriangleMesh> >
auto make_gradient_domain_solver(const TriangleMesh& tm, const CGAL_NP_CLASS& np = parameters::default_values())
{
  typedef internal::Parameter_type<CGAL::internal_np::sparse_linear_solver_t, CGAL_NP_CLASS,
                                   Default_sparse_linear_solver>
    Solver;
  return Gradient_domain_solver<TriangleMesh, Solver>(tm, np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * returns a `Gradient_domain_solver` for a region of the mesh, with the linear solver that is named in `np`.
 */
template <class FaceRange, class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_mesh<TriangleMesh> >
auto make_gradient_domain_solver(const FaceRange& region, const TriangleMesh& tm,
                                 const CGAL_NP_CLASS& np = parameters::default_values())
{
  typedef internal::Parameter_type<CGAL::internal_np::sparse_linear_solver_t, CGAL_NP_CLASS,
                                   Default_sparse_linear_solver> Solver;
  return Gradient_domain_solver<TriangleMesh, Solver>(region, tm, np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * returns a `Gradient_domain_solver` for a soup: points and polygons that index them, with any number of polygons at an
 * edge. The descriptors of its vertices and faces are indices, of type `std::size_t`.
 *
 * \tparam PointRange a model of `RandomAccessContainer` whose value is a point: with `operator[]` or `x()`, `y()`,
 *         `z()`
 * \tparam PolygonRange a model of `RandomAccessContainer` whose value is a range of indices
 */
template <class PointRange, class PolygonRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_range<const PolygonRange>, class = void>
auto make_gradient_domain_solver(const PointRange& points, const PolygonRange& polygons,
                                 const CGAL_NP_CLASS& np = parameters::default_values())
{
  typedef internal::Parameter_type<CGAL::internal_np::sparse_linear_solver_t, CGAL_NP_CLASS,
                                   Default_sparse_linear_solver> Solver;
  typedef internal::Polygon_soup<const PointRange, PolygonRange> Soup;
  return Gradient_domain_solver<Soup, Solver>(Soup{points, polygons}, np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * returns a `Gradient_domain_solver` for a region of a soup, given by the indices of its polygons.
 */
template <class FaceRange, class PointRange, class PolygonRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_range<const PolygonRange> >
auto make_gradient_domain_solver(const FaceRange& region, const PointRange& points, const PolygonRange& polygons,
                                 const CGAL_NP_CLASS& np = parameters::default_values())
{
  typedef internal::Parameter_type<CGAL::internal_np::sparse_linear_solver_t, CGAL_NP_CLASS,
                                   Default_sparse_linear_solver> Solver;
  typedef internal::Polygon_soup<const PointRange, PolygonRange> Soup;
  return Gradient_domain_solver<Soup, Solver>(region, Soup{points, polygons}, np);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_MAKE_GRADIENT_DOMAIN_SOLVER_H
