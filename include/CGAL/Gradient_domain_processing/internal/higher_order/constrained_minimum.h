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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_CONSTRAINED_MINIMUM_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_CONSTRAINED_MINIMUM_H

#include <CGAL/Gradient_domain_processing/Error_code.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The rows and columns of the free degrees of freedom, numbered in their order; the lower triangle only.
Eigen::SparseMatrix<double> free_block(const Eigen::SparseMatrix<double>& matrix, const std::vector<int>& free_index,
                                       int count);

// Minimizes x^T Q x, channel by channel, over the free rows of x; the constrained ones are eliminated and stay to the
// bit. It is solved for the change: where x is a minimizer already, it stays but for rounding.
Error_code constrained_minimum(const Eigen::SparseMatrix<double>& matrix, const std::vector<char>& is_free,
                               Eigen::MatrixXd& x);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/higher_order/constrained_minimum_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_CONSTRAINED_MINIMUM_H
