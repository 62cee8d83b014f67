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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_HESSIAN_MATRIX_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_HESSIAN_MATRIX_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/Hessian_kind.h>
#include <CGAL/Gradient_domain_processing/parameters.h>
#include <CGAL/Gradient_domain_processing/internal/energy/matrices.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/hessian_energy.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {

namespace internal {

// What function(input, unit) makes of a mesh with its metrics, in the numbers of the vertex index map: degree of
// freedom d of vertex v is d + dimension * v. Lengths in the input, those of its metrics included, are in units of the
// arrays.
template <class TriangleMesh, class NamedParameters, class Function>
Error_code assemble_second_order(const TriangleMesh& tm, int dimension, const NamedParameters& np,
                                 const Function& function, Eigen::SparseMatrix<double>& matrix)
{
  Matrix_input input;
  if(const Error_code code = read_matrix_input(tm, np, input))
    return code;
  const double unit = input.mesh.unit();
  for(Triangle_metric& metric : input.metrics.given)
    metric = metric.scaled(1 / (unit * unit));
  const Eigen::SparseMatrix<double> of_arrays = function(static_cast<const Matrix_input&>(input), unit);

  std::vector<int> numbers;
  for(int v : input.vertex_index)
    for(int k = 0; k < dimension; ++k)
      numbers.push_back(dimension * v + k);
  std::vector<Eigen::Triplet<double> > entries;
  entries.reserve(std::size_t(of_arrays.nonZeros()));
  for(int j = 0; j < int(of_arrays.cols()); ++j)
    for(Eigen::SparseMatrix<double>::InnerIterator it(of_arrays, j); it; ++it)
      entries.emplace_back(numbers[std::size_t(it.row())], numbers[std::size_t(j)], it.value());
  const int size = dimension * index_range(input.vertex_index);
  Eigen::SparseMatrix<double> result(size, size);
  result.setFromTriplets(entries.begin(), entries.end());
  matrix.swap(result);
  return ok;
}

} // namespace internal

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * assembles the matrix \f$ Q \f$ of an energy of second derivatives, \f$ u^T Q u \f$ (Stein, Jacobson, Wardetzky,
 * Grinspun: *A Smoothness Energy without Boundary Distortion for Curved Surfaces*, 2020). With \f$ \gamma Q \f$ added
 * to \f$ \alpha M + \beta S \f$ the energy has one more term, \f$ \gamma |\nabla \nabla g|^2 \f$.
 *
 * Where the metric differs from face to face, an edge has two lengths. Its squared lengths are averaged, unless that
 * leaves a face less than half of its area.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 *
 * \param tm the triangle mesh
 * \param kind which energy
 * \param hessian the result, \f$ |V| \times |V| \f$, symmetric and stored as a whole, in 1 / squared lengths of the
 *        mesh. Vertices without a face have zero rows.
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `face_metric_map`,
 *        `vertex_point_map`, `vertex_index_map` and `concurrency_tag` of `mass_matrix()`
 *
 * \return `ok`; or what is wrong, and then the matrix is as it was
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code hessian_matrix(const TriangleMesh& tm, Hessian_kind kind, Eigen::SparseMatrix<double>& hessian,
                          const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto in_units = [&](const internal::Matrix_input& input, double unit) {
    Eigen::SparseMatrix<double> matrix = internal::hessian_energy(input.mesh, input.metrics, kind, input.parallel);
    matrix *= 1 / (unit * unit);
    return matrix;
  };
  return internal::assemble_second_order(tm, 1, np, in_units, hessian);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_HESSIAN_MATRIX_H
