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
#include <CGAL/Gradient_domain_processing/parameters.h>
#include <CGAL/Gradient_domain_processing/internal/energy/matrices.h>
#include <CGAL/Gradient_domain_processing/internal/spectrum/Laplace_spectrum.h>
#include <CGAL/Gradient_domain_processing/internal/spectrum/read_masks.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {

namespace internal {

template <class NamedParameters>
Eigenpair_request eigenpair_request(int count, const NamedParameters& np)
{
  using namespace CGAL::internal_np;
  Eigenpair_request request;
  request.count = count;
  request.is_lowest = !Has_parameter<spectral_shift_t, NamedParameters>::value;
  request.shift = double(parameter(np, spectral_shift, 0.));
  request.parallel =
    is_parallel<Parameter_type<concurrency_tag_t, NamedParameters, Parallel_if_available_tag> >();
  return request;
}

// `region` is one, or none.
template <class Surface, class NamedParameters, class... Region>
Error_code spectrum_of_surface(const Surface& surface, int count, Eigen::VectorXd& eigenvalues,
                               Eigen::MatrixXd& harmonics, const NamedParameters& np, const Region&... region)
{
  Matrix_input input;
  Spectrum_masks masks;
  Error_code code = read_matrix_input(surface, np, input, true);
  if constexpr(sizeof...(Region) > 0)
    if(code == ok)
      code = constrain_outside(region..., surface, np, input, masks);
  if(code == ok)
    code = read_masks(surface, np, input, masks);
  Eigenpairs pairs;
  if(code == ok)
    code = laplace_spectrum(input, masks, parameter(np, CGAL::internal_np::embedding_measure, false),
                            eigenpair_request(count, np), pairs);
  if(code != ok)
    return code;
  eigenvalues.swap(pairs.values);
  harmonics.swap(pairs.vectors);
  return ok;
}

} // namespace internal

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * computes eigenvalues and eigenfunctions of the Laplacian, \f$ S \phi = \lambda M \phi \f$: the manifold harmonics
 * (Vallet, Levy: *Spectral Geometry Processing with Manifold Harmonics*, 2008), under any metric; the lowest, or those
 * nearest to a shift. They come slice by slice, each around a shift of its own, two at a time; how many there are
 * between two shifts is counted, so that none of a multiple eigenvalue is missed. Time grows with `count` and with the
 * mesh a little faster than linearly; memory is that of the result and some hundred vectors.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 *
 * \param tm the mesh, of triangles or other polygons
 * \param count how many, not more than there are vertices with a face that are not constrained
 * \param eigenvalues the result, increasing, in 1 / squared lengths of the mesh
 * \param harmonics one column each, with \f$ \phi^T M \phi = 1 \f$; rows are numbered by `vertex_index_map`, those of
 *        constrained vertices and of vertices without a face are zero
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `face_metric_map`,
 *        `vertex_point_map`, `vertex_index_map`, `concurrency_tag` of `mass_matrix()`, `vertex_is_constrained_map`
 *        (where harmonics are zero), and
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{vertex_value_weight_map}
 *     \cgalParamDescription{a mask \f$ \alpha \f$, how much the values at a vertex count: \f$ M \f$ is that of \f$ \alpha
 *                           \f$, linear between vertices, at least 0. Where all around a vertex it is 0, harmonics are}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with key `vertex_descriptor` and a number type as value}
 *     \cgalParamDefault{1 everywhere}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{face_gradient_weight_map}
 *     \cgalParamDescription{a mask \f$ \beta \f$, how well a face conducts: \f$ S_f \f$ is multiplied by it; at least 0.
 *                           Where values count and no face conducts, every vertex has an eigenvalue 0 of its own}
 *     \cgalParamType{a class model of `ReadablePropertyMap` with key `face_descriptor` and a number type as value}
 *     \cgalParamDefault{1 everywhere}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{spectral_shift}
 *     \cgalParamDescription{the `count` eigenvalues nearest to this one, in 1 / squared lengths of the mesh, instead of
 *                           the lowest: \f$ (2 \pi / \ell)^2 \f$ for waves about as long as \f$ \ell \f$}
 *     \cgalParamType{`double`, finite}
 *     \cgalParamDefault{none}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{embedding_measure}
 *     \cgalParamDescription{whether areas are those of the embedding, in \f$ M \f$ and in \f$ S \f$, and
 *                           `face_metric_map` tells only how long gradients are: \f$ S_f = A_f G^T g^{-1} G \f$.
 *                           Stretches \f$ s_i \f$ along the principal directions then are a conductance \f$ D =
 *                           diag(1 / s_1, 1 / s_2) \f$, as in the anisotropic Laplacian \f$ div (D \nabla) \f$ of
 *                           Andreux et al. 2014, where \f$ s_i = 1 + a |\kappa_i| \f$; a metric alone has \f$ \det D
 *                           = 1 \f$ in two dimensions, and slows waves down by more area instead}
 *     \cgalParamType{`bool`}
 *     \cgalParamDefault{`false`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return `ok`; or what is wrong, and then the results are as they were
 */
template <class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_mesh<TriangleMesh> >
Error_code spectrum(const TriangleMesh& tm, int count, Eigen::VectorXd& eigenvalues, Eigen::MatrixXd& harmonics,
                    const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::spectrum_of_surface(tm, count, eigenvalues, harmonics, np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so in a region of the mesh: vertices with a face outside are constrained, harmonics are zero there.
 *
 * \param region a range of `face_descriptor`; `error_invalid_region` where one is none of the mesh
 * \param tm, count, eigenvalues, harmonics, np as above
 */
template <class FaceRange, class TriangleMesh, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_mesh<TriangleMesh>, class = internal::Enable_if_range<const FaceRange> >
Error_code spectrum(const FaceRange& region, const TriangleMesh& tm, int count, Eigen::VectorXd& eigenvalues,
                    Eigen::MatrixXd& harmonics, const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::spectrum_of_surface(tm, count, eigenvalues, harmonics, np, region);
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
          class = internal::Enable_if_range<const PointRange>, class = internal::Enable_if_range<const PolygonRange>,
          class = void>
Error_code spectrum(const PointRange& points, const PolygonRange& polygons, int count, Eigen::VectorXd& eigenvalues,
                    Eigen::MatrixXd& harmonics, const CGAL_NP_CLASS& np = parameters::default_values())
{
  const internal::Polygon_soup<const PointRange, PolygonRange> soup{points, polygons};
  return internal::spectrum_of_surface(soup, count, eigenvalues, harmonics, np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so in a region of a soup, a range of indices of polygons.
 */
template <class FaceRange, class PointRange, class PolygonRange, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_range<const PointRange>, class = internal::Enable_if_range<const PolygonRange> >
Error_code spectrum(const FaceRange& region, const PointRange& points, const PolygonRange& polygons, int count,
                    Eigen::VectorXd& eigenvalues, Eigen::MatrixXd& harmonics,
                    const CGAL_NP_CLASS& np = parameters::default_values())
{
  const internal::Polygon_soup<const PointRange, PolygonRange> soup{points, polygons};
  return internal::spectrum_of_surface(soup, count, eigenvalues, harmonics, np, region);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so for any symmetric matrix that is bounded from below, \f$ A x = \lambda M x \f$: that of `hessian_matrix()`,
 * `modified_dirichlet_matrix()`, or, with the mass of every vertex three times, of `shell_hessian_matrix()` (the modes
 * of Hildebrandt et al. 2012).
 *
 * \param matrix \f$ A \f$, stored as a whole
 * \param mass \f$ M \f$, symmetric positive semidefinite, stored as a whole; where its diagonal is zero there is no
 *        degree of freedom
 * \param count how many, not more than there are degrees of freedom that are not constrained
 * \param eigenvalues the result, increasing
 * \param vectors one column each, with \f$ x^T M x = 1 \f$
 * \param np `spectral_shift`, `concurrency_tag` as above, and `vertex_is_constrained_map`, which has rows of the
 *        matrix, of type `std::size_t`, as keys
 *
 * \return `ok`; or what is wrong, and then the results are as they were
 */
template <typename CGAL_NP_TEMPLATE_PARAMETERS>
Error_code spectrum(const Eigen::SparseMatrix<double>& matrix, const Eigen::SparseMatrix<double>& mass, int count,
                    Eigen::VectorXd& eigenvalues, Eigen::MatrixXd& vectors,
                    const CGAL_NP_CLASS& np = parameters::default_values())
{
  std::vector<char> is_free(std::size_t(mass.rows()));
  for(std::size_t i = 0; i < is_free.size(); ++i)
  {
    is_free[i] = mass.coeff(Eigen::Index(i), Eigen::Index(i)) > 0;
    if constexpr(internal::Has_parameter<CGAL::internal_np::vertex_is_constrained_t, CGAL_NP_CLASS>::value)
      is_free[i] = is_free[i] && !get(internal::parameter(np, CGAL::internal_np::vertex_is_constrained, 0), i);
  }
  internal::Eigenpairs pairs;
  if(const Error_code code = internal::restricted_spectrum(
       matrix, mass, internal::numbered_in_memory_order(is_free), internal::eigenpair_request(count, np), pairs))
    return code;
  eigenvalues.swap(pairs.values);
  vectors.swap(pairs.vectors);
  return ok;
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_SPECTRUM_H
