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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_ERROR_CODE_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_ERROR_CODE_H

#include <CGAL/license/Gradient_domain_processing.h>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingEnums
 *
 * What a function of this package answers. Whenever it is not `ok`, the mesh and all output property maps are exactly
 * as they were before the call.
 *
 * The names are in small letters because some of those in capitals are macros of `<windows.h>` or `<curses.h>`. Those
 * in capitals (`OK`, `ERROR_EMPTY_MESH`, ...) are constants of the same values, wherever no macro has taken them.
 */
enum [[nodiscard]] Error_code
{
  ok,                               ///< Success.
  error_empty_mesh,                 ///< The mesh has no face.
  /// A face is not a triangle where one is needed, such as for a metric tensor of your own; or it has fewer than three
  /// corners.
  error_non_triangular_mesh,
  error_invalid_point,              ///< A coordinate is NaN, infinite, or larger than 1e150.
  error_invalid_signal,             ///< A value of the input signal is NaN or infinite.
  error_invalid_target,             ///< A target gradient or a given normal or curvature is NaN or infinite.
  error_invalid_weight,             ///< A weight is negative, NaN or infinite.
  error_invalid_metric,             ///< A metric tensor is not symmetric positive definite.
  error_invalid_parameter,          ///< Another parameter is out of its range.
  /// A face or vertex of the region is none of the mesh: removed, null or out of range.
  error_invalid_region,
  error_invalid_index,              ///< A vertex index of a face is out of range, or two vertices have the same index.
  /// The value weight is zero on a component (of the faces with a gradient weight) without a constrained vertex: the
  /// solution is not unique.
  error_unconstrained,
  /// Restoring the volume was asked for, but a component is open, has a constraint, or has collapsed.
  error_no_volume,
  error_cannot_solve_linear_system, ///< The linear solver failed: its factorization broke down or ran out of memory.
  error_not_converged,              ///< An iterative linear solver did not reach its tolerance.
  error_result_out_of_range,        ///< The result overflows the number type of the output.
  error_cancelled                   ///< The visitor cancelled.
};

/// \cond SKIP_IN_MANUAL
#ifndef OK
constexpr Error_code OK = ok;
#endif
#ifndef ERROR_EMPTY_MESH
constexpr Error_code ERROR_EMPTY_MESH = error_empty_mesh;
#endif
#ifndef ERROR_NON_TRIANGULAR_MESH
constexpr Error_code ERROR_NON_TRIANGULAR_MESH = error_non_triangular_mesh;
#endif
#ifndef ERROR_INVALID_POINT
constexpr Error_code ERROR_INVALID_POINT = error_invalid_point;
#endif
#ifndef ERROR_INVALID_SIGNAL
constexpr Error_code ERROR_INVALID_SIGNAL = error_invalid_signal;
#endif
#ifndef ERROR_INVALID_TARGET
constexpr Error_code ERROR_INVALID_TARGET = error_invalid_target;
#endif
#ifndef ERROR_INVALID_WEIGHT
constexpr Error_code ERROR_INVALID_WEIGHT = error_invalid_weight;
#endif
#ifndef ERROR_INVALID_METRIC
constexpr Error_code ERROR_INVALID_METRIC = error_invalid_metric;
#endif
#ifndef ERROR_INVALID_PARAMETER
constexpr Error_code ERROR_INVALID_PARAMETER = error_invalid_parameter;
#endif
#ifndef ERROR_INVALID_REGION
constexpr Error_code ERROR_INVALID_REGION = error_invalid_region;
#endif
#ifndef ERROR_INVALID_INDEX
constexpr Error_code ERROR_INVALID_INDEX = error_invalid_index;
#endif
#ifndef ERROR_UNCONSTRAINED
constexpr Error_code ERROR_UNCONSTRAINED = error_unconstrained;
#endif
#ifndef ERROR_NO_VOLUME
constexpr Error_code ERROR_NO_VOLUME = error_no_volume;
#endif
#ifndef ERROR_CANNOT_SOLVE_LINEAR_SYSTEM
constexpr Error_code ERROR_CANNOT_SOLVE_LINEAR_SYSTEM = error_cannot_solve_linear_system;
#endif
#ifndef ERROR_NOT_CONVERGED
constexpr Error_code ERROR_NOT_CONVERGED = error_not_converged;
#endif
#ifndef ERROR_RESULT_OUT_OF_RANGE
constexpr Error_code ERROR_RESULT_OUT_OF_RANGE = error_result_out_of_range;
#endif
#ifndef ERROR_CANCELLED
constexpr Error_code ERROR_CANCELLED = error_cancelled;
#endif
/// \endcond

/*!
 * \ingroup PkgGradientDomainProcessingEnums
 *
 * returns the sentence that explains an error code.
 * \param code what a function of this package returned
 */
inline const char* get_error_message(int code)
{
  switch(code)
  {
    case ok: return "Success";
    case error_empty_mesh: return "The mesh has no face";
    case error_non_triangular_mesh: return "A face of the mesh is not a triangle";
    case error_invalid_point: return "A coordinate is NaN, infinite or out of range";
    case error_invalid_signal: return "A value of the signal is NaN or infinite";
    case error_invalid_target: return "A target gradient, normal or curvature is NaN or infinite";
    case error_invalid_weight: return "A weight is negative, NaN or infinite";
    case error_invalid_metric: return "A metric tensor is not symmetric positive definite";
    case error_invalid_parameter: return "A parameter is out of its range";
    case error_invalid_region: return "A face or vertex of the region is none of the mesh";
    case error_invalid_index: return "A vertex index is out of range";
    case error_unconstrained: return "The value weight is zero on a component with too few constrained vertices";
    case error_no_volume: return "The volume of an open, unoriented, constrained or collapsed mesh cannot be restored";
    case error_cannot_solve_linear_system: return "The linear system cannot be solved";
    case error_not_converged: return "The iterative linear solver did not converge";
    case error_result_out_of_range: return "The result overflows the number type of the output";
    case error_cancelled: return "Cancelled by the visitor";
    default: return "Unknown error";
  }
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_ERROR_CODE_H
