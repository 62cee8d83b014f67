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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_DIVERGENCE_MATRIX_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_DIVERGENCE_MATRIX_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/internal/energy/matrices.h>

namespace CGAL {
namespace Gradient_domain_processing {

namespace internal {

template <class Surface, class NamedParameters>
Error_code divergence_matrix(const Surface& surface, const NamedParameters& np, Eigen::SparseMatrix<double>& divergence)
{
  Matrix_input input;
  if(const Error_code code = read_matrix_input(surface, np, input))
    return code;
  Eigen::SparseMatrix<double> columns(index_range(input.vertex_index), 2 * index_range(input.face_index));
  columns.reserve(Eigen::VectorXi::Constant(columns.cols(), 3));
  for(int f = 0; f < input.mesh.number_of_triangles(); ++f)
  {
    const auto& t = input.mesh.triangles[f];
    const Triangle_metric metric = input.metrics(input.mesh, f);
    const double at_0 = half_cotangent(metric, 0), at_1 = half_cotangent(metric, 1), at_2 = half_cotangent(metric, 2);
    const int first = 2 * input.face_index[f];
    const auto add = [&](int corner, double by_t1, double by_t2) {
      columns.coeffRef(input.vertex_index[t[corner]], first) += by_t1;
      columns.coeffRef(input.vertex_index[t[corner]], first + 1) += by_t2;
    };
    add(0, -at_2, -at_1);
    add(1, at_2 + at_0, -at_0);
    add(2, -at_0, at_1 + at_0);
  }
  columns.makeCompressed();
  divergence.swap(columns);
  return ok;
}

} // namespace internal

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * assembles the divergence matrix \f$ D_{ij} = \int \langle \nabla \phi_i, \omega_j \rangle \f$ (paper, section 2.2 and
 * appendix A.3): on a triangle \f$ D = a\, G^T g^{-1} \f$ with its area \f$ a \f$. It takes covectors on the faces, as
 * `gradient_matrix()` makes them, to the right-hand side of the energy's system.
 * A tangent vector \f$ w \f$ in space is the covector \f$ (\langle w, t_1 \rangle, \langle w, t_2 \rangle) \f$.
 *
 * \param tm the triangle mesh
 * \param divergence the result, \f$ |V| \times 2 |F| \f$
 * \param np as those of `mass_matrix()`, and `face_index_map`
 *
 * \return `ok`; or what is wrong, and then the matrix is as it was
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code divergence_matrix(const TriangleMesh& tm, Eigen::SparseMatrix<double>& divergence,
                             const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::divergence_matrix(tm, np, divergence);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so for a soup: points and triangles connected in any way. Rows and columns are numbered by the indices of points
 * and triangles; there is no `vertex_point_map`, and nothing is welded.
 */
template <class PointRange, class TriangleRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_range<const PointRange>, class = internal::Enable_if_range<const TriangleRange> >
Error_code divergence_matrix(const PointRange& points, const TriangleRange& triangles,
                             Eigen::SparseMatrix<double>& divergence,
                             const CGAL_NP_CLASS& np = parameters::default_values())
{
  const internal::Polygon_soup<const PointRange, TriangleRange> soup{points, triangles};
  return internal::divergence_matrix(soup, np, divergence);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_DIVERGENCE_MATRIX_H
