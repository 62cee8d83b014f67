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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_DEFAULT_SPARSE_LINEAR_SOLVER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_DEFAULT_SPARSE_LINEAR_SOLVER_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <CGAL/Eigen_solver_traits.h>

#include <Eigen/SparseCholesky>
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * The linear solver of this package unless another is passed: CHOLMOD's supernodal Cholesky factorization where
 * `CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD` is defined (the CMake target does so where it finds SuiteSparse), else
 * that of Eigen. Both are \f$ LL^T \f$, which notices a matrix that is not positive definite.
 *
 * \cgalModels{SparseLinearAlgebraWithFactorTraits_d}
 */
#ifdef DOXYGEN_RUNNING
typedef unspecified_type Default_sparse_linear_solver;
#elif defined(CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD)
typedef Eigen_solver_traits<Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>, Eigen::Lower> >
  Default_sparse_linear_solver;
#else
typedef Eigen_solver_traits<
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int> > >
  Default_sparse_linear_solver;
#endif

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_DEFAULT_SPARSE_LINEAR_SOLVER_H
