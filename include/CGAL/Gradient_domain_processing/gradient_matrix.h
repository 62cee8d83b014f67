// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_GRADIENT_MATRIX_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_GRADIENT_MATRIX_H

#include <CGAL/Gradient_domain_processing/internal/energy/matrices.h>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * assembles the gradient matrix \f$ G \f$ (paper, appendix A.2). It takes the values at the vertices to covectors on the faces: rows
 * \f$ 2 f \f$ and \f$ 2 f + 1 \f$ are the differences along \f$ t_1 = v_1 - v_0 \f$ and \f$ t_2 = v_2 - v_0 \f$ (see `Triangle_metric`).
 * It does not depend on the metric.
 *
 * \param tm the triangle mesh
 * \param gradient the result, \f$ 2 |F| \times |V| \f$; faces are numbered by `face_index_map`, vertices by `vertex_index_map`
 * \param np as those of `mass_matrix()`, and `face_index_map`
 *
 * \return `ok`; or what is wrong, and then the matrix is as it was
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code gradient_matrix(const TriangleMesh& tm, Eigen::SparseMatrix<double>& gradient,
                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::Matrix_input input;
  if(const Error_code code = internal::read_matrix_input(tm, np, input))
    return code;
  Eigen::SparseMatrix<double, Eigen::RowMajor> rows(2 * internal::index_range(input.face_index),
                                                    internal::index_range(input.vertex_index));
  rows.reserve(Eigen::VectorXi::Constant(rows.rows(), 2));
  for(int f = 0; f < input.mesh.number_of_triangles(); ++f)
    for(int i = 0; i < 2; ++i)
    {
      const auto& t = input.mesh.triangles[f];
      rows.insert(2 * input.face_index[f] + i, input.vertex_index[t[0]]) = -1;
      rows.insert(2 * input.face_index[f] + i, input.vertex_index[t[i + 1]]) = 1;
    }
  gradient = rows;
  return ok;
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_GRADIENT_MATRIX_H
