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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_LINEAR_SYSTEM_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_LINEAR_SYSTEM_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/visitor.h>
#include <CGAL/Gradient_domain_processing/internal/energy/Energy_weights.h>
#include <CGAL/Gradient_domain_processing/internal/energy/second_order.h>
#include <CGAL/Gradient_domain_processing/internal/energy/sparsity_pattern.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Any_linear_solver.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/Degrees_of_freedom.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>
#include <CGAL/Gradient_domain_processing/internal/metric/Triangle_metrics.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The system (alpha M + beta S) (g - f) = beta (D v - S f) (eq. 2) on arrays; with a term of second order,
// (alpha M + beta S + gamma Q) (g - f) = beta (D v - S f) - gamma Q f. It is solved for the change of the signal, so
// that the rounding error is that of the change, and what need not change does not.
class Linear_system
{
public:
  Indexed_triangles mesh;
  std::vector<char> is_constrained; // by vertex: its value is prescribed
  bool parallel = true;

  // What the matrix is made of.
  struct Coefficients
  {
    Triangle_metrics metrics;
    Energy_weights weights;
    Second_order_energy second_order;
    int constraints_of_second_order = 1; // how many it needs where nothing else acts
  };

private:
  Coefficients m_coefficients;
  Degrees_of_freedom m_dofs;
  Degrees_of_freedom m_dofs_with_virtual_vertices; // where there are any: what is assembled before it is reduced
  Sparse_matrix m_prolongation;          // from the former to the latter, where there are any
  Lists m_pattern;                       // of the matrix that is assembled, by column, for as long as the system lives
  Sparse_matrix m_matrix;                // with it, from the analysis to the first factorization
  Sparse_matrix m_second_order;          // gamma Q over all vertices, where there is such a term
  Sparse_matrix m_unshifted;
  std::unique_ptr<Any_linear_solver> m_solver;
  bool m_is_analyzed = false, m_is_pattern_analyzed = false, m_is_factorized = false, m_values_weigh_little = false;

public:
  explicit Linear_system(std::unique_ptr<Any_linear_solver> solver) : m_solver(std::move(solver)) {}

  Triangle_metric metric(int f) const { return m_coefficients.metrics(mesh, f); }
  const Triangle_metrics& metrics() const { return m_coefficients.metrics; }
  const Energy_weights& weights() const { return m_coefficients.weights; }
  const Degrees_of_freedom& degrees_of_freedom() const { return m_dofs; }

  void set_metrics(Untouched_vector<Triangle_metric> metrics)
  {
    m_coefficients.metrics.given = std::move(metrics);
    m_is_factorized = false;
  }

  void set_embedding_metric() { set_metrics({}); }

  void set_weights(Energy_weights weights)
  {
    m_coefficients.weights = std::move(weights);
    m_is_factorized = false;
  }

  // With or without it the matrix has another pattern.
  void set_second_order(Second_order_energy energy, int needed_constraints = 1)
  {
    if(!energy && !has_second_order())
      return;
    m_coefficients.second_order = std::move(energy);
    m_coefficients.constraints_of_second_order = needed_constraints;
    m_is_analyzed = m_is_factorized = false;
  }

  // lambda is on the right-hand side only
  void set_scale(double scale) { m_coefficients.weights.set_scale(scale); }

  // Other coefficients for a while.
  Coefficients exchange_coefficients(Coefficients coefficients)
  {
    std::swap(m_coefficients, coefficients);
    if(m_coefficients.second_order || coefficients.second_order)
      m_is_analyzed = false;
    m_is_factorized = false;
    return coefficients;
  }

  // Other vertices are constrained: everything is made anew.
  void set_constrained(std::vector<char> constrained)
  {
    is_constrained = std::move(constrained);
    m_is_analyzed = m_is_factorized = false;
  }

  Error_code factorize(Progress& progress);

  // The change g - f of a signal whose target is given by what it asks for beyond the signal's own gradients (see
  // right_hand_side.h), by vertex. On entry, `displacement` holds the change of the constrained vertices, if
  // `displaces_constraints`. Where an iterative solver does not converge, Cholesky takes its place, from then on.
  template <class Target_field>
  Error_code solve(const Target_field& target, Progress& progress, Signal& displacement,
                   bool displaces_constraints = false);

private:
  template <class Target_field>
  Error_code solve_as_it_is(const Target_field& target, Progress& progress, Signal& displacement,
                            bool displaces_constraints);

  // Of one matrix and one solution: what comes after is not known here.
  Solver_task solver_task(std::size_t number_of_unknowns) const;

  bool has_virtual_vertices() const { return mesh.virtual_vertices.size() > 0; }
  bool has_second_order() const { return bool(m_coefficients.second_order); }
  // Not that of neighbors: the solver sees it with the first values.
  bool has_own_pattern() const { return has_virtual_vertices() || has_second_order(); }
  const Degrees_of_freedom& assembled_dofs() const
  {
    return has_virtual_vertices() ? m_dofs_with_virtual_vertices : m_dofs;
  }

  // Orders the degrees of freedom, makes the pattern and lets the solver analyze it. Depends on the connectivity and
  // the constrained vertices only.
  Error_code analyze(Progress& progress);

  void assemble_into(Sparse_matrix& matrix);

  // gamma Q f
  void subtract_second_order(const Signal& by_vertex, Eigen::MatrixXd& residual) const;

  // Components of very different size, or nearly degenerate triangles, may lose the positive definiteness to rounding.
  // A shift of the diagonal brings it back, and refinement takes the shift out of the solution.
  Error_code factorize_or_shift(Sparse_matrix& matrix, Progress& progress);

  Error_code solve_residual(Eigen::MatrixXd& residual, Progress& progress, Signal& displacement,
                            bool displaces_constraints);

  // Virtual vertices count with what their constrained corners move them by; the rest of their move is solved for.
  void move_constraints_to_right_hand_side(const Signal& displacement, Eigen::MatrixXd& residual) const;

  // The solution takes the place of the right-hand side.
  Error_code solve_refined(Eigen::MatrixXd& values, Progress& progress);

  Eigen::MatrixXd multiply(const Eigen::MatrixXd& x) const;
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/energy/Linear_system_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_LINEAR_SYSTEM_H
