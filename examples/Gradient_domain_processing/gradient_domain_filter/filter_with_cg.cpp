// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "filter_mesh_impl.h"

#include <CGAL/Gradient_domain_processing/Conjugate_gradient_solver_traits.h>

using CGAL::Gradient_domain_processing::Error_code;

typedef CGAL::Gradient_domain_processing::Conjugate_gradient_solver_traits<> Conjugate_gradients;

Error_code filter_with_cg(const Options& options, Mesh_file& file, Stage_clock& clock, Filter_facts& facts)
{
  constexpr double tolerance = 1e-10;
  filter_mesh_impl::Filter<Conjugate_gradients> filter(options, file, clock, facts, Conjugate_gradients(tolerance));
  const Error_code code = filter.run();
  const bool has_converged = filter.solver().error() <= tolerance; // else Cholesky took its place
  facts.solver = has_converged ? "cg" : filter_mesh_impl::default_solver_name();
  if(code == CGAL::Gradient_domain_processing::ok && has_converged)
    facts.iterations = double(filter.solver().iterations());
  return code;
}
