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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_HESSIAN_KIND_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_HESSIAN_KIND_H

#include <CGAL/license/Gradient_domain_processing.h>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingEnums
 *
 * The energy of second derivatives. All are sums over the mesh under its metric; on a plane, far from borders, all have
 * the same minimizers.
 */
enum class Hessian_kind
{
  /// \f$ \int |\nabla \nabla u|^2 \f$ with natural borders: functions that are linear on a plane cost nothing, whatever
  /// its border. Semidefinite under every metric.
  SQUARED_HESSIAN,
  /// \f$ \int |\nabla \nabla u|^2 + \kappa |\nabla u|^2 \f$ with the Gaussian curvature \f$ \kappa \f$ and natural
  /// borders, the energy of Stein, Jacobson, Wardetzky and Grinspun (2020): inside a surface it has the minimizers of
  /// `BILAPLACIAN`. It is indefinite where a surface of negative curvature has a border, and \f$ \kappa \f$ needs a
  /// metric whose edges have one length.
  CURVED_HESSIAN,
  /// The part of `SQUARED_HESSIAN` without a trace, \f$ \int |\nabla \nabla u|^2 - (\Delta u)^2 / 2 \f$: the
  /// coordinates of a sphere cost nothing, so that patches become round. Semidefinite under every metric; needs
  /// constraints.
  TRACE_FREE_HESSIAN,
  /// \f$ \int (\Delta u)^2 \f$ as \f$ S M^{-1} S \f$ with a lumped mass. No slope across borders, which bends isolines
  /// there.
  BILAPLACIAN
};

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_HESSIAN_KIND_H
