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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_STIFFNESS_MATRIX_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_STIFFNESS_MATRIX_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/internal/energy/matrices.h>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * assembles the stiffness matrix \f$ S_{ij} = \int \langle \nabla \phi_i, \nabla \phi_j \rangle \f$ (paper, appendix
 * A.4), positive semi-definite, the cotangent Laplacian with positive diagonal under the metric of the embedding. Its
 * rows sum up to zero; \f$ S = D G \f$.
 *
 * \param tm the mesh; polygons take part by their virtual vertices, if no `face_metric_map` is given
 * \param stiffness the result, \f$ |V| \times |V| \f$, symmetric and stored as a whole, without unit
 * \param np as those of `mass_matrix()`
 *
 * \return `ok`; or what is wrong, and then the matrix is as it was
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code stiffness_matrix(const TriangleMesh& tm, Eigen::SparseMatrix<double>& stiffness,
                            const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::assemble_matrix(tm, 0, 1, np, stiffness);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so for a soup: points and polygons connected in any way. Rows and columns are numbered by the indices of points
 * and polygons; there is no `vertex_point_map`, and nothing is welded.
 */
template <class PointRange, class PolygonRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_range<const PointRange>, class = internal::Enable_if_range<const PolygonRange> >
Error_code stiffness_matrix(const PointRange& points, const PolygonRange& polygons,
                            Eigen::SparseMatrix<double>& stiffness,
                            const CGAL_NP_CLASS& np = parameters::default_values())
{
  const internal::Polygon_soup<const PointRange, PolygonRange> soup{points, polygons};
  return internal::assemble_matrix(soup, 0, 1, np, stiffness);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_STIFFNESS_MATRIX_H
