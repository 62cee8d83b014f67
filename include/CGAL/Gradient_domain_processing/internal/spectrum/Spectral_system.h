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
// factorization of M + S / c serves all fractions of the cut-off c: it solves those of first degree, and its square,
// (M + S / c) M^-1 (M + S / c), is close to those of second degree, (z + 1)^2 to z^2 + 2 shift z + 1, so that conjugate
// gradients need about twenty steps for eight digits, however large the mesh is.
class Spectral_system
{
  static constexpr double tolerance = 1e-8; // of the error in the energy's norm, relative to the solution
  static constexpr int most_steps = 500;

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

  // Filters a signal by degree of freedom.
  Error_code apply(const Rational_filter& filter, Progress& progress, Eigen::MatrixXd& signal);

private:
  Error_code factorize(double cut_off, Progress& progress);

  // The matrix is symmetric: its columns are its rows.
  Eigen::MatrixXd times_stiffness(const Eigen::MatrixXd& x) const;

  // (M + 2 shift S / c + S M^-1 S / c^2) x
  Eigen::MatrixXd times_second_degree(const Rational_filter::Fraction& fraction, const Eigen::MatrixXd& x) const;

  // Conjugate gradients on all channels side by side, each with its own steps.
  Error_code solve_second_degree(const Rational_filter::Fraction& fraction, Progress& progress,
                                 const Eigen::MatrixXd& right, Eigen::MatrixXd& x);
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/spectrum/Spectral_system_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_SPECTRAL_SYSTEM_H
