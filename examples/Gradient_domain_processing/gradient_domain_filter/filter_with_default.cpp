// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "filter_mesh_impl.h"

using CGAL::Gradient_domain_processing::Default_sparse_linear_solver;
using CGAL::Gradient_domain_processing::Error_code;

Error_code filter_with_default(const Options& options, Mesh_file& file, Stage_clock& clock, Filter_facts& facts)
{
  filter_mesh_impl::Filter<Default_sparse_linear_solver> filter(options, file, clock, facts);
  const Error_code code = filter.run();
  facts.solver = filter_mesh_impl::default_solver_name();
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD
  const cholmod_common& common = filter.solver().solver().cholmod();
  if(code == CGAL::Gradient_domain_processing::ok && common.lnz > 0)
  {
    facts.matrix_non_zeros = common.anz;
    facts.factor_non_zeros = common.lnz;
  }
#else
  if(code == CGAL::Gradient_domain_processing::ok && filter.solver().solver().rows() > 0)
    facts.factor_non_zeros = double(filter.solver().solver().matrixL().nestedExpression().nonZeros());
#endif
  return code;
}
