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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_SPARSITY_PATTERN_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_SPARSITY_PATTERN_H

#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/Degrees_of_freedom.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Lists.h>

#include <Eigen/SparseCore>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

typedef Eigen::SparseMatrix<double> Sparse_matrix;

// The sparsity pattern of alpha M + beta S, the rows of every column in increasing order: all of them, or those of the
// lower triangle.
Lists sparsity_pattern(const Lists& rings, const Degrees_of_freedom& dofs, bool lower_only, bool parallel);

// Makes it a square matrix with this pattern, its values still to be set.
void set_pattern(const Lists& pattern, bool parallel, Sparse_matrix& matrix);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/energy/sparsity_pattern_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_SPARSITY_PATTERN_H
