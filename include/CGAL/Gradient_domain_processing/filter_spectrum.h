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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_FILTER_SPECTRUM_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_FILTER_SPECTRUM_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>
#include <CGAL/Gradient_domain_processing/Spectral_filter.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/filter_spectrum_of_signal.h>
#include <CGAL/Gradient_domain_processing/internal/spectrum/eigenpairs.h>
#include <CGAL/Gradient_domain_processing/internal/spectrum/filter_by_harmonics.h>

#include <algorithm>
#include <type_traits>

namespace CGAL {
namespace Gradient_domain_processing {

namespace internal {

template <class InMap, class OutMap, class Transfer, class Solver, class NamedParameters>
Error_code filter_spectrum(InMap in, OutMap out, const Transfer& transfer, Solver solver, const NamedParameters& np)
{
  typedef Parameter_type<CGAL::internal_np::sparse_linear_solver_t, NamedParameters, Default_sparse_linear_solver>
    Linear_solver_traits;
  const int count = int(parameter(np, CGAL::internal_np::number_of_harmonics, 100));
  if(count < 0)
    return error_invalid_parameter;
  if(solver.error() != ok)
    return solver.error();
  auto& filter = solver.arrays();
  const double squared_unit = filter.mesh().unit() * filter.mesh().unit();
  const auto apply = [&](auto& system, Eigen::MatrixXd& values) -> Error_code {
    if constexpr (std::is_same<Transfer, Spectral_filter>::value)
      return system.apply(transfer.rational().scaled(squared_unit), filter.progress(), values);
    else
    {
      Eigenpairs harmonics;
      const Sparse_matrix mass(system.masses().asDiagonal());
      if(const Error_code code =
           lowest_eigenpairs(system.stiffness(), mass, (std::min)(count, int(values.rows())), harmonics,
                             system.is_parallel()))
        return code;
      const auto of_arrays = [&](double mu) { return double(transfer((std::max)(0., mu) / squared_unit)); };
      const double of_the_rest =
        harmonics.values.size() > 0 ? of_arrays(harmonics.values[harmonics.values.size() - 1]) : of_arrays(0);
      values = filter_by_harmonics(harmonics, mass, values, of_arrays, of_the_rest);
      return values.allFinite() ? ok : error_invalid_parameter;
    }
  };
  return solver.checked(filter_spectrum_of_signal(
    in, out, any_linear_solver(parameter(np, CGAL::internal_np::sparse_linear_solver, Linear_solver_traits())),
    solver.elements(), filter, apply));
}

// Before anything is read.
inline bool is_valid_transfer(const Spectral_filter& filter) { return filter.is_valid(); }
template <class Transfer>
bool is_valid_transfer(const Transfer&) { return true; }

} // namespace internal

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * filters a signal by a transfer function \f$ h(\mu) \f$ of the eigenvalues of the Laplacian, \f$ S \phi = \mu M \phi
 * \f$ with a lumped \f$ M \f$ and under any metric of this package: the part of the signal along each harmonic \f$ \phi
 * \f$ is multiplied by \f$ h(\mu) \f$.
 *
 * With a `Spectral_filter` (low-pass, high-pass, band-pass, band-stop, with cut-offs that are wavelengths in the unit
 * of the mesh, or an approximation of any function) it does so without any harmonics, by one factorization a cut-off
 * and some tens of solutions, and keeps the bound that the filter states. With any other function it computes the
 * lowest `number_of_harmonics` harmonics; what is orthogonal to all of them is multiplied by the value at the last.
 *
 * Harmonics are zero at constrained vertices, which keep their values: filtered is what the signal has beside the
 * harmonic function that agrees with it there. Vertices of a fixed border and those with a face outside of the region
 * count as constrained; `Border_condition::ALONG_BORDER` as `Border_condition::FIXED`.
 *
 * \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
 * \tparam InMap a model of `ReadablePropertyMap` with key `vertex_descriptor` and any value that `Signal_traits` knows
 * \tparam OutMap a model of `WritablePropertyMap` with a value of the same dimension
 * \tparam TransferFunction `Spectral_filter`, or a functor from `double` to `double`
 *
 * \param tm the triangle mesh; it is not changed
 * \param in the signal
 * \param out the result; may be `in`
 * \param transfer the transfer function; \f$ \mu \f$ is in 1 / squared lengths of the mesh
 * \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of `Gradient_domain_solver`
 *        that describe metric, constraints, seams, linear solver, threads and visitor, and
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{number_of_harmonics}
 *     \cgalParamDescription{how many are computed for a functor; all, if there are fewer}
 *     \cgalParamType{`unsigned int`}
 *     \cgalParamDefault{`100`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \return `ok`; or what is wrong, and then `out` is as it was: `error_invalid_parameter` for a `Spectral_filter` that
 *         is not valid, or a transfer function that is not finite
 *
 * \sa `spectrum()`
 */
template <class TriangleMesh, class InMap, class OutMap, class TransferFunction, typename CGAL_NP_TEMPLATE_PARAMETERS,
          class = internal::Enable_if_mesh<TriangleMesh> >
Error_code filter_spectrum(const TriangleMesh& tm, InMap in, OutMap out, const TransferFunction& transfer,
                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  if(!internal::is_valid_transfer(transfer))
    return error_invalid_parameter;
  return internal::filter_spectrum(in, out, transfer, make_gradient_domain_solver(tm, np), np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so in a region of the mesh.
 *
 * \param region a range of `face_descriptor`; may be empty
 * \param tm, in, out, transfer, np as above
 */
template <class FaceRange, class TriangleMesh, class InMap, class OutMap, class TransferFunction,
          typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_mesh<TriangleMesh>,
          class = internal::Enable_if_range<const FaceRange> >
Error_code filter_spectrum(const FaceRange& region, const TriangleMesh& tm, InMap in, OutMap out,
                           const TransferFunction& transfer, const CGAL_NP_CLASS& np = parameters::default_values())
{
  if(!internal::is_valid_transfer(transfer))
    return error_invalid_parameter;
  return internal::filter_spectrum(in, out, transfer, make_gradient_domain_solver(region, tm, np), np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so on a soup, with any number of polygons at an edge. Property maps have indices, of type `std::size_t`, as
 * keys.
 *
 * \param points a model of `RandomAccessContainer` of points
 * \param polygons a model of `RandomAccessContainer` whose value is a range of indices of points
 * \param in, out, transfer, np as above
 */
template <class PointRange, class PolygonRange, class InMap, class OutMap, class TransferFunction,
          typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_range<const PointRange>,
          class = internal::Enable_if_range<const PolygonRange>, class = void>
Error_code filter_spectrum(const PointRange& points, const PolygonRange& polygons, InMap in, OutMap out,
                           const TransferFunction& transfer, const CGAL_NP_CLASS& np = parameters::default_values())
{
  if(!internal::is_valid_transfer(transfer))
    return error_invalid_parameter;
  return internal::filter_spectrum(in, out, transfer, make_gradient_domain_solver(points, polygons, np), np);
}

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * does so in a region of a soup, a range of indices of polygons.
 */
template <class FaceRange, class PointRange, class PolygonRange, class InMap, class OutMap, class TransferFunction,
          typename CGAL_NP_TEMPLATE_PARAMETERS, class = internal::Enable_if_range<const PointRange>,
          class = internal::Enable_if_range<const PolygonRange> >
Error_code filter_spectrum(const FaceRange& region, const PointRange& points, const PolygonRange& polygons, InMap in,
                           OutMap out, const TransferFunction& transfer,
                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  if(!internal::is_valid_transfer(transfer))
    return error_invalid_parameter;
  return internal::filter_spectrum(in, out, transfer, make_gradient_domain_solver(region, points, polygons, np), np);
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_FILTER_SPECTRUM_H
