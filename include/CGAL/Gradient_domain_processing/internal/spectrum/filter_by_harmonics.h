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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_FILTER_BY_HARMONICS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_FILTER_BY_HARMONICS_H

#include <CGAL/Gradient_domain_processing/internal/spectrum/Block_lanczos.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Multiplies the part of a signal along every harmonic by the transfer function of its eigenvalue, and what is
// orthogonal to all of them by one number.
template <class TransferFunction>
Eigen::MatrixXd filter_by_harmonics(const Eigenpairs& harmonics, const Eigen::SparseMatrix<double>& mass,
                                    const Eigen::MatrixXd& signal, const TransferFunction& transfer, double of_the_rest)
{
  Eigen::MatrixXd parts = harmonics.vectors.transpose() * (mass * signal);
  for(Eigen::Index j = 0; j < parts.rows(); ++j)
    parts.row(j) *= transfer(harmonics.values[j]) - of_the_rest;
  return of_the_rest * signal + harmonics.vectors * parts;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_FILTER_BY_HARMONICS_H
