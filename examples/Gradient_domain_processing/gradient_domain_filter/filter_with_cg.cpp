// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "filter_mesh_impl.h"

using CGAL::Gradient_domain_processing::Error_code;

typedef CGAL::Eigen_solver_traits<Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower> > Conjugate_gradients;

Error_code filter_with_cg(const Options& options, Mesh_file& file, Stage_clock& clock, Solver_facts& facts)
{
  filter_mesh_impl::Filter<Conjugate_gradients> filter(options, file, clock);
  facts.name = "cg";
  const Error_code code = filter.run();
  if(code == CGAL::Gradient_domain_processing::OK && filter.solver().solver().rows() > 0)
    facts.iterations = double(filter.solver().solver().iterations());
  return code;
}
