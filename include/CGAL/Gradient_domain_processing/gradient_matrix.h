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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_GRADIENT_MATRIX_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_GRADIENT_MATRIX_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/internal/energy/matrices.h>

namespace CGAL {
namespace Gradient_domain_processing {

namespace internal {

template <class Surface, class NamedParameters>
Error_code gradient_matrix(const Surface& surface, const NamedParameters& np, Eigen::SparseMatrix<double>& gradient)
{
  Matrix_input input;
  if(const Error_code code = read_matrix_input(surface, np, input))
    return code;
  Eigen::SparseMatrix<double, Eigen::RowMajor> rows(2 * index_range(input.face_index), index_range(input.vertex_index));
  rows.reserve(Eigen::VectorXi::Constant(rows.rows(), 2));
  for(int f = 0; f < input.mesh.number_of_triangles(); ++f)
    for(int i = 0; i < 2; ++i)
    {
      const auto& t = input.mesh.triangles[f];
      rows.coeffRef(2 * input.face_index[f] + i, input.vertex_index[t[0]]) -= 1; // corners may coincide
      rows.coeffRef(2 * input.face_index[f] + i, input.vertex_index[t[i + 1]]) += 1;
    }
  gradient = rows;
  return ok;
}

} // namespace internal

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * assembles the gradient matrix \f$ G \f$ (paper, appendix A.2). It takes the values at the vertices to covectors on
 * the faces: rows
 * \f$ 2 f \f$ and \f$ 2 f + 1 \f$ are the differences along \f$ t_1 = v_1 - v_0 \f$ and \f$ t_2 = v_2 - v_0 \f$ (see
 * `Triangle_metric`). It does not depend on the metric.
 *
 * \param tm the triangle mesh
 * \param gradient the result, \f$ 2 |F| \times |V| \f$; faces are numbered by `face_index_map`, vertices by
 *        `vertex_index_map`
 * \param np as those of `mass_matrix()`, and `face_index_map`
 *
 * \return `ok`; or what is wrong, and then the matrix is as it was
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code gradient_matrix(const TriangleMesh& tm, Eigen::SparseMatrix<double>& gradient,
                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::gradient_matrix(tm, np, gradient);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so for a soup: points and triangles connected in any way. Rows and columns are numbered by the indices of points
 * and triangles; there is no `vertex_point_map`, and nothing is welded.
 */
template <class PointRange, class TriangleRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_range<const PointRange>, class = internal::Enable_if_range<const TriangleRange> >
Error_code gradient_matrix(const PointRange& points, const TriangleRange& triangles,
                           Eigen::SparseMatrix<double>& gradient,
                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  const internal::Polygon_soup<const PointRange, TriangleRange> soup{points, triangles};
  return internal::gradient_matrix(soup, np, gradient);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_GRADIENT_MATRIX_H
