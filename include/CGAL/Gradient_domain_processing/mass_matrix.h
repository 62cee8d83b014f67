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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_MASS_MATRIX_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_MASS_MATRIX_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/internal/energy/matrices.h>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * assembles the mass matrix \f$ M_{ij} = \int \phi_i \phi_j \f$ of the hat functions (paper, section 2.2 and appendix
 * A.1). On a triangle of area \f$ a \f$ it is \f$ \frac{a}{12} (2, 1, 1; 1, 2, 1; 1, 1, 2) \f$; all its entries
 * together sum up to the area.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 *
 * \param tm the mesh; polygons take part by their virtual vertices, if no `face_metric_map` is given
 * \param mass the result, \f$ |V| \times |V| \f$, symmetric and stored as a whole, in squared lengths of the mesh; rows
 *        and columns are numbered by `vertex_index_map`. Vertices without a face have zero rows.
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{face_metric_map}
 *     \cgalParamDescription{the metric of every face}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with key `face_descriptor` and value `Triangle_metric`}
 *     \cgalParamDefault{the metric of the embedding}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the vertices}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with key `vertex_descriptor` and a `Point_3` as value}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_index_map}
 *     \cgalParamDescription{the number of every vertex}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with key `vertex_descriptor` and value `std::size_t`}
 *     \cgalParamDefault{an automatically indexed internal map}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{concurrency_tag}
 *     \cgalParamDescription{whether two or more threads work (with TBB)}
 *     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`}
 *     \cgalParamDefault{`CGAL::Parallel_if_available_tag`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return `ok`; or what is wrong, and then the matrix is as it was
 *
 * Complexity: proportional to the number of vertices.
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code mass_matrix(const TriangleMesh& tm, Eigen::SparseMatrix<double>& mass,
                       const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::assemble_matrix(tm, 1, 0, np, mass);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so for a soup: points and polygons connected in any way. Rows and columns are numbered by the indices of points
 * and polygons; there is no `vertex_point_map`, and nothing is welded.
 */
template <class PointRange, class PolygonRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_range<const PointRange>, class = internal::Enable_if_range<const PolygonRange> >
Error_code mass_matrix(const PointRange& points, const PolygonRange& polygons, Eigen::SparseMatrix<double>& mass,
                       const CGAL_NP_CLASS& np = parameters::default_values())
{
  const internal::Polygon_soup<const PointRange, PolygonRange> soup{points, polygons};
  return internal::assemble_matrix(soup, 1, 0, np, mass);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_MASS_MATRIX_H
