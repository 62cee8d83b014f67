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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_SPECTRUM_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_SPECTRUM_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/mass_matrix.h>
#include <CGAL/Gradient_domain_processing/parameters.h>
#include <CGAL/Gradient_domain_processing/stiffness_matrix.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/constrained_minimum.h>
#include <CGAL/Gradient_domain_processing/internal/spectrum/eigenpairs.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {

namespace internal {

// The lowest eigenpairs on the free degrees of freedom; the rows of the others are zero.
inline Error_code free_eigenpairs(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b,
                                  const std::vector<char>& is_free, int count, Eigenpairs& result)
{
  std::vector<int> free_index(is_free.size(), -1);
  int number = 0;
  for(std::size_t i = 0; i < is_free.size(); ++i)
    if(is_free[i])
      free_index[i] = number++;
  if(count < 0 || count > number)
    return error_invalid_parameter;
  const auto block = [&](const Eigen::SparseMatrix<double>& matrix) {
    return Eigen::SparseMatrix<double>(free_block(matrix, free_index, number).selfadjointView<Eigen::Lower>());
  };
  Eigenpairs of_free;
  if(count > 0)
    if(const Error_code code = lowest_eigenpairs(block(a), block(b), count, of_free))
      return code;
  result.values = of_free.values;
  result.vectors.setZero(Eigen::Index(is_free.size()), count);
  for(std::size_t i = 0; i < is_free.size() && count > 0; ++i)
    if(is_free[i])
      result.vectors.row(Eigen::Index(i)) = of_free.vectors.row(free_index[i]);
  return ok;
}

// `is_constrained` by number of a vertex.
inline Error_code spectrum(const Eigen::SparseMatrix<double>& mass, const Eigen::SparseMatrix<double>& stiffness,
                           const std::vector<char>& is_constrained, int count, Eigen::VectorXd& eigenvalues,
                           Eigen::MatrixXd& harmonics)
{
  std::vector<char> is_free(std::size_t(mass.rows()));
  for(std::size_t i = 0; i < is_free.size(); ++i)
    is_free[i] = !is_constrained[i] && mass.coeff(Eigen::Index(i), Eigen::Index(i)) > 0;
  Eigenpairs pairs;
  if(const Error_code code = free_eigenpairs(stiffness, mass, is_free, count, pairs))
    return code;
  eigenvalues.swap(pairs.values);
  harmonics.swap(pairs.vectors);
  return ok;
}

} // namespace internal

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * computes the lowest eigenvalues and eigenfunctions of the Laplacian, \f$ S \phi = \lambda M \phi \f$: the manifold
 * harmonics (Vallet, Levy: *Spectral Geometry Processing with Manifold Harmonics*, 2008), under any metric. They come
 * band by band, each around a shift; how many there are below a shift is counted, so that none of a multiple eigenvalue
 * is missed.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 *
 * \param tm the mesh, of triangles or other polygons
 * \param count how many, not more than there are vertices with a face that are not constrained
 * \param eigenvalues the result, increasing, in 1 / squared lengths of the mesh
 * \param harmonics one column each, with \f$ \phi^T M \phi = 1 \f$; rows are numbered by `vertex_index_map`, those of
 *        constrained vertices and of vertices without a face are zero
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `face_metric_map`,
 *        `vertex_point_map`, `vertex_index_map`, `concurrency_tag` of `mass_matrix()`, and `vertex_is_constrained_map`:
 *        where harmonics are zero
 *
 * \return `ok`; or what is wrong, and then the results are as they were
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code spectrum(const TriangleMesh& tm, int count, Eigen::VectorXd& eigenvalues, Eigen::MatrixXd& harmonics,
                    const CGAL_NP_CLASS& np = parameters::default_values())
{
  Eigen::SparseMatrix<double> mass, stiffness;
  if(const Error_code code = mass_matrix(tm, mass, np))
    return code;
  if(const Error_code code = stiffness_matrix(tm, stiffness, np))
    return code;

  std::vector<char> is_constrained(std::size_t(mass.rows()), 0);
  if constexpr(internal::Has_parameter<CGAL::internal_np::vertex_is_constrained_t, CGAL_NP_CLASS>::value)
  {
    const auto index_map = CGAL::get_initialized_vertex_index_map(tm, np);
    for(auto v : vertices(tm))
      if(get(internal::parameter(np, CGAL::internal_np::vertex_is_constrained, 0), v))
        is_constrained[std::size_t(get(index_map, v))] = 1;
  }
  return internal::spectrum(mass, stiffness, is_constrained, count, eigenvalues, harmonics);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so on a soup, with any number of polygons at an edge. Rows of the harmonics are those of the points; points
 * beyond the last that a polygon uses have none.
 *
 * \param points a model of `RandomAccessContainer` of points
 * \param polygons a model of `RandomAccessContainer` whose value is a range of indices of points
 * \param count, eigenvalues, harmonics, np as above; property maps have indices, of type `std::size_t`, as keys
 */
template <class PointRange, class PolygonRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_range<const PolygonRange> >
Error_code spectrum(const PointRange& points, const PolygonRange& polygons, int count, Eigen::VectorXd& eigenvalues,
                    Eigen::MatrixXd& harmonics, const CGAL_NP_CLASS& np = parameters::default_values())
{
  Eigen::SparseMatrix<double> mass, stiffness;
  if(const Error_code code = mass_matrix(points, polygons, mass, np))
    return code;
  if(const Error_code code = stiffness_matrix(points, polygons, stiffness, np))
    return code;
  std::vector<char> is_constrained(std::size_t(mass.rows()), 0);
  if constexpr(internal::Has_parameter<CGAL::internal_np::vertex_is_constrained_t, CGAL_NP_CLASS>::value)
    for(std::size_t v = 0; v < is_constrained.size(); ++v)
      is_constrained[v] = bool(get(internal::parameter(np, CGAL::internal_np::vertex_is_constrained, 0), v));
  return internal::spectrum(mass, stiffness, is_constrained, count, eigenvalues, harmonics);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_SPECTRUM_H
