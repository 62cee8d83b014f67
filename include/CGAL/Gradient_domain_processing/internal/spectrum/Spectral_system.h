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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_SPECTRAL_SYSTEM_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_SPECTRAL_SYSTEM_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/visitor.h>
#include <CGAL/Gradient_domain_processing/internal/energy/sparsity_pattern.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Any_linear_solver.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/Degrees_of_freedom.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>
#include <CGAL/Gradient_domain_processing/internal/metric/Triangle_metrics.h>
#include <CGAL/Gradient_domain_processing/internal/spectrum/Rational_filter.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// S and a lumped M of the vertices that are not constrained, and what filters signals by the eigenvalues of (S, M). One
// factorization of M + S / c serves a series around c: t = (mu - c) / (mu + c) is 1 - 2 (M + S / c)^-1 M, and every
// degree costs one solution.
class Spectral_system
{
  Degrees_of_freedom m_dofs;
  Sparse_matrix m_stiffness; // stored as a whole
  Eigen::VectorXd m_masses;
  std::unique_ptr<Any_linear_solver> m_solver;
  bool m_parallel;

public:
  Spectral_system(std::unique_ptr<Any_linear_solver> solver, bool parallel)
    : m_solver(std::move(solver))
    , m_parallel(parallel)
  {
  }

  bool is_parallel() const { return m_parallel; }
  const Degrees_of_freedom& degrees_of_freedom() const { return m_dofs; }
  const Sparse_matrix& stiffness() const { return m_stiffness; }
  const Eigen::VectorXd& masses() const { return m_masses; }

  Error_code assemble_matrices(const Indexed_triangles& mesh, const Triangle_metrics& metrics,
                               const std::vector<char>& is_constrained, Progress& progress);

  // Filters a signal by degree of freedom. Where an iterative solver does not converge, Cholesky takes its place.
  Error_code apply(const Rational_filter& filter, Progress& progress, Eigen::MatrixXd& signal);

private:
  Error_code apply_as_it_is(const Rational_filter& filter, Progress& progress, Eigen::MatrixXd& signal);

  Error_code factorize(double center, Progress& progress);

  // By the recurrence of Chebyshev's polynomials.
  Error_code add(const Chebyshev_series& series, Progress& progress, const Eigen::MatrixXd& signal,
                 Eigen::MatrixXd& sum);
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/spectrum/Spectral_system_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_SPECTRAL_SYSTEM_H
