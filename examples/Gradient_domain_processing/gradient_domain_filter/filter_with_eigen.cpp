// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "filter_mesh_impl.h"

// Where there is no CHOLMOD this is the default.
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD

using CGAL::Gradient_domain_processing::Error_code;

typedef CGAL::Eigen_solver_traits<
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int> > >
  Eigen_cholesky;

Error_code filter_with_eigen(const Options& options, Mesh_file& file, Stage_clock& clock, Filter_facts& facts)
{
  filter_mesh_impl::Filter<Eigen_cholesky> filter(options, file, clock, facts);
  facts.solver = "eigen";
  const Error_code code = filter.run();
  if(code == CGAL::Gradient_domain_processing::ok && filter.solver().solver().rows() > 0)
    facts.factor_non_zeros = double(filter.solver().solver().matrixL().nestedExpression().nonZeros());
  return code;
}

#endif
