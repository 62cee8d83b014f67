// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_ERROR_CODE_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_ERROR_CODE_H

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingEnums
 *
 * What a function of this package answers. Whenever it is not `OK`, the mesh and all output property maps are exactly as
 * they were before the call.
 */
enum Error_code
{
  OK,                               ///< Success.
  ERROR_EMPTY_MESH,                 ///< The mesh has no face.
  ERROR_NON_TRIANGULAR_MESH,        ///< A face is not a triangle.
  ERROR_INVALID_POINT,              ///< A coordinate is NaN, infinite, or larger than 1e150.
  ERROR_INVALID_SIGNAL,             ///< A value of the input signal is NaN or infinite.
  ERROR_INVALID_TARGET,             ///< A target gradient or a given normal or curvature is NaN or infinite.
  ERROR_INVALID_WEIGHT,             ///< A weight is negative, NaN or infinite.
  ERROR_INVALID_METRIC,             ///< A metric tensor is not symmetric positive definite.
  ERROR_INVALID_PARAMETER,          ///< Another parameter is out of its range.
  ERROR_UNCONSTRAINED,              ///< The value weight is zero on a component (of the faces with a gradient weight) without a constrained vertex: the solution is not unique.
  ERROR_NO_VOLUME,                  ///< Restoring the volume was asked for, but a component is open or has a constraint.
  ERROR_CANNOT_SOLVE_LINEAR_SYSTEM, ///< The linear solver failed: its factorization broke down or ran out of memory.
  ERROR_NOT_CONVERGED,              ///< An iterative linear solver did not reach its tolerance.
  ERROR_RESULT_OUT_OF_RANGE,        ///< The result overflows the number type of the output.
  ERROR_CANCELLED                   ///< The visitor cancelled.
};

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
    case OK: return "Success";
    case ERROR_EMPTY_MESH: return "The mesh has no face";
    case ERROR_NON_TRIANGULAR_MESH: return "A face of the mesh is not a triangle";
    case ERROR_INVALID_POINT: return "A coordinate is NaN, infinite or out of range";
    case ERROR_INVALID_SIGNAL: return "A value of the signal is NaN or infinite";
    case ERROR_INVALID_TARGET: return "A target gradient, normal or curvature is NaN or infinite";
    case ERROR_INVALID_WEIGHT: return "A weight is negative, NaN or infinite";
    case ERROR_INVALID_METRIC: return "A metric tensor is not symmetric positive definite";
    case ERROR_INVALID_PARAMETER: return "A parameter is out of its range";
    case ERROR_UNCONSTRAINED: return "The value weight is zero on a component without a constrained vertex";
    case ERROR_NO_VOLUME: return "The volume of an open or constrained component cannot be restored";
    case ERROR_CANNOT_SOLVE_LINEAR_SYSTEM: return "The linear system cannot be solved";
    case ERROR_NOT_CONVERGED: return "The iterative linear solver did not converge";
    case ERROR_RESULT_OUT_OF_RANGE: return "The result overflows the number type of the output";
    case ERROR_CANCELLED: return "Cancelled by the visitor";
    default: return "Unknown error";
  }
}

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_ERROR_CODE_H
