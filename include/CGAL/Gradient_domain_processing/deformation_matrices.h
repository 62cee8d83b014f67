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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_DEFORMATION_MATRICES_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_DEFORMATION_MATRICES_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/hessian_matrix.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/modified_dirichlet.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/shell_hessian.h>

#include <Eigen/SparseCore>

#include <cmath>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * assembles the modified Dirichlet energy of Hildebrandt, Schulz, von Tycowicz and Polthier (*Modal Shape Analysis
 * beyond Laplacian*, 2012), \f$ \int |\nabla u|^2 + (k_1^2 + k_2^2) u^2 = u^T A u \f$, as \f$ A_{ij} = \langle N_i, N_j
 * \rangle S_{ij} \f$ with unit normals
 * \f$ N \f$ at the vertices: a smoothness of displacements along the normals that counts where the surface is curved.
 * Semidefinite; \f$ S \f$ on a plane.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 *
 * \param tm the triangle mesh
 * \param matrix the result, \f$ |V| \times |V| \f$, without unit
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `face_metric_map`,
 *        `vertex_point_map`, `vertex_index_map` and `concurrency_tag` of `mass_matrix()`
 *
 * \return `ok`; or what is wrong, and then the matrix is as it was
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code modified_dirichlet_matrix(const TriangleMesh& tm, Eigen::SparseMatrix<double>& matrix,
                                     const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto of_arrays = [](const internal::Matrix_input& input, double) {
    return internal::modified_dirichlet(input.mesh, input.metrics, input.mesh.vertex_normals(input.parallel),
                                        input.parallel);
  };
  return internal::assemble_second_order(tm, 1, np, of_arrays, matrix);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * assembles the Hessian of the deformation energy of a discrete shell at rest (Hildebrandt et al. 2012, equation 13):
 * with the dihedral angles, edge lengths and areas as \f$ f \f$, the sum of \f$ w \nabla f \nabla f^T \f$, where \f$ w
 * \f$ is `3 bending` \f$ |e|^2 \f$ over the areas of its two faces, `length` \f$ / |e| \f$, and `area` over the area.
 * Semidefinite, with the rigid motions in its kernel.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 *
 * \param tm the triangle mesh
 * \param bending, length, area the stiffness against each, not negative
 * \param matrix the result, \f$ 3 |V| \times 3 |V| \f$; coordinate \f$ k \f$ of vertex \f$ v \f$ has the number \f$ 3 v
 *        + k \f$
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `vertex_point_map`,
 *        `vertex_index_map` and `concurrency_tag` of `mass_matrix()`
 *
 * \return `ok`; or what is wrong, and then the matrix is as it was
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code shell_hessian_matrix(const TriangleMesh& tm, double bending, double length, double area,
                                Eigen::SparseMatrix<double>& matrix,
                                const CGAL_NP_CLASS& np = parameters::default_values())
{
  if(!(bending >= 0 && length >= 0 && area >= 0 && std::isfinite(bending + length + area)))
    return error_invalid_weight;
  const auto in_units = [&](const internal::Matrix_input& input, double unit) {
    return internal::shell_hessian(input.mesh, {bending / (unit * unit), length / unit, area}, input.parallel);
  };
  return internal::assemble_second_order(tm, 3, np, in_units, matrix);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_DEFORMATION_MATRICES_H
