// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_LINEAR_SYSTEM_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_LINEAR_SYSTEM_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/visitor.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Linear_solver.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>
#include <CGAL/Gradient_domain_processing/internal/energy/assembly.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/connected_components.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/elimination_order.h>

#include <numeric>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The system (alpha M + beta S) (g - f) = beta (D v - S f) on arrays. It is solved for the change of the signal, so that the
// rounding error is that of the change, and what need not change does not.
template <class SparseLinearSolver>
class Linear_system
{
public:
  Indexed_triangles mesh;
  std::vector<char> is_constrained; // by vertex: its value is prescribed
  bool parallel = true;

private:
  Triangle_metrics m_metrics;
  Weights m_weights;
  Degrees_of_freedom m_unknowns;
  Lists m_pattern; // of the matrix, by column, for as long as the system lives
  Sparse_matrix m_matrix; // with it, from the analysis to the first factorization
  Sparse_matrix m_unshifted;
  Linear_solver<SparseLinearSolver> m_solver;
  bool m_is_analyzed = false, m_is_factorized = false, m_values_weigh_little = false;

public:
  explicit Linear_system(const SparseLinearSolver& solver) : m_solver(solver) {}

  Triangle_metric metric(int f) const { return m_metrics(mesh, f); }
  const Weights& weights() const { return m_weights; }
  const Degrees_of_freedom& unknowns() const { return m_unknowns; }
  bool is_analyzed() const { return m_is_analyzed; }

  void set_metrics(Untouched_vector<Triangle_metric> metrics)
  {
    m_metrics.given = std::move(metrics);
    m_is_factorized = false;
  }

  void set_embedding_metric() { set_metrics({}); }

  void set_weights(const Weights& weights)
  {
    m_weights = weights;
    m_is_factorized = false;
  }

  // lambda is on the right-hand side only
  void set_scale(double scale)
  {
    m_weights.scale = scale;
    m_weights.scale_at_face.clear();
  }

  // Orders the unknowns, makes the pattern and lets the solver analyze it. Depends on the connectivity and the constrained
  // vertices only.
  Error_code analyze(Progress& progress)
  {
    if(m_is_analyzed)
      return OK;
    if(!progress.go_on(0))
      return ERROR_CANCELLED;
    Stage_scope stage(progress, Stage::ANALYZE);

    const Lists rings = mesh.one_rings(parallel);
    std::vector<char> is_solved_for(mesh.points.size());
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      is_solved_for[v] = !is_constrained[v] && mesh.corners.size(v) > 0;
    m_unknowns = elimination_order(mesh.points, rings, is_solved_for, parallel);
    m_pattern = sparsity_pattern(rings, m_unknowns, m_solver.reads_lower_triangle, parallel);
    set_pattern(m_pattern, parallel, m_matrix);
    const Error_code code = m_unknowns.size() > 0 ? m_solver.analyze(m_matrix) : OK;
    m_is_analyzed = code == OK;
    return code;
  }

  Error_code factorize(Progress& progress)
  {
    if(m_is_factorized && (m_unknowns.size() == 0 || m_solver.has_factor()))
      return OK;
    m_is_factorized = false;
    if(has_floating_component())
      return ERROR_UNCONSTRAINED;
    if(const Error_code code = analyze(progress))
      return code;
    if(m_unknowns.size() > 0)
    {
      if(!progress.go_on(0))
        return ERROR_CANCELLED;
      Sparse_matrix matrix; // the solver has a factor or a copy of it, so it need not stay
      {
        Stage_scope stage(progress, Stage::ASSEMBLE);
        matrix.swap(m_matrix);
        if(matrix.rows() == 0)
          set_pattern(m_pattern, parallel, matrix);
        m_values_weigh_little = assemble(mesh, m_metrics, m_weights, m_unknowns, parallel, matrix);
      }
      if(!progress.go_on(0))
        return ERROR_CANCELLED;
      Stage_scope stage(progress, Stage::FACTOR);
      if(const Error_code code = factorize_or_shift(matrix))
        return code;
    }
    m_is_factorized = true;
    return OK;
  }

  // The change g - f of a signal of so many channels whose target gradients exceed its own by `excess` (see assembly.h). On
  // entry, `displacement` holds the change of the constrained vertices, if `displaces_constraints`.
  template <class Excess>
  Error_code solve(const Excess& excess, int channels, Progress& progress, Signal& displacement,
                   bool displaces_constraints = false)
  {
    if(const Error_code code = factorize(progress))
      return code;
    const auto clear_displacement = [&] {
      if(!displaces_constraints)
        displacement.setZero(mesh.number_of_vertices(), channels);
    };
    if(m_unknowns.size() == 0)
    {
      clear_displacement();
      return OK;
    }

    if(!progress.go_on(0))
      return ERROR_CANCELLED;
    Eigen::MatrixXd residual(m_unknowns.size(), channels);
    {
      Stage_scope stage(progress, Stage::ASSEMBLE);
      gradient_residual(mesh, m_metrics, m_weights, m_unknowns, excess, parallel, residual);
      if(displaces_constraints)
        move_to_right_hand_side(mesh, m_metrics, m_weights, m_unknowns, displacement, parallel, residual);
    }
    Stage_scope stage(progress, Stage::SOLVE);
    if(const Error_code code = solve_refined(residual))
      return code;
    clear_displacement(); // not before: memory is scarcest in the solver
    for_each_degree_of_freedom(parallel, m_unknowns, [&](int v, int row) { displacement.row(v) = residual.row(row); });
    if(m_values_weigh_little)
      center(displacement);
    return displacement.allFinite() ? OK : ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  }

  // v = lambda grad f. The values of the vertices are vectors, by channel.
  template <class Values>
  auto excess_of_filter(const Values& values) const
  {
    return [this, values](int f, int i, int j) {
      const auto& t = mesh.triangles[f];
      return (m_weights.scale_at(f) - 1) * (values(t[j]) - values(t[i]));
    };
  }

  auto excess_of_filter(const Signal& signal) const
  {
    return excess_of_filter([&signal](int v) { return signal.row(v); });
  }

  auto excess_of_filter(const std::vector<Vec3>& points) const
  {
    return excess_of_filter([&points](int v) { return Eigen::Map<const Vec3>(points[v].data()); });
  }

private:
  // Components of very different size, or nearly degenerate triangles, may lose the positive definiteness to rounding. A shift
  // of the diagonal brings it back, and refinement takes the shift out of the solution.
  Error_code factorize_or_shift(Sparse_matrix& matrix)
  {
    m_unshifted = Sparse_matrix();
    Error_code code = m_solver.factorize(matrix);
    if(code == OK || m_solver.is_iterative)
      return code;
    m_unshifted = matrix;
    for(int j = 0; j < m_unknowns.size(); ++j)
      matrix.coeffRef(j, j) *= 1 + 1e-10;
    return m_solver.factorize(matrix);
  }

  // The solution takes the place of the right-hand side.
  Error_code solve_refined(Eigen::MatrixXd& values)
  {
    if(m_unshifted.size() == 0)
      return m_solver.solve(values, values);
    const Eigen::MatrixXd right = values;
    Error_code code = m_solver.solve(right, values);
    if(code != OK)
      return code;
    Eigen::MatrixXd rest = right - multiply(values), correction;
    for(int step = 0; step < 4; ++step)
    {
      code = m_solver.solve(rest, correction);
      if(code != OK)
        return code;
      const Eigen::MatrixXd better = values + correction, less = right - multiply(better);
      if(!(less.norm() < rest.norm()))
        break;
      values = better;
      rest = less;
    }
    return OK;
  }

  // Targets are differences along edges, so what they ask for sums up to zero: on a component without constraints the mean of
  // the change, weighted by the values' part of the system, is zero.
  void center(Signal& displacement) const
  {
    Weights value_weights = m_weights;
    value_weights.gradient = 0;
    value_weights.gradient_at_face.clear();

    const Components components = connected_components(mesh);
    std::vector<double> mass(components.count, 0);
    std::vector<char> is_held(components.count, 0), is_at_rest(mesh.number_of_vertices(), 1);
    Signal moment = Signal::Zero(components.count, displacement.cols());
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
    {
      double weight = 0;
      for(const int* c = mesh.corners.begin(v); c != mesh.corners.end(v); ++c)
      {
        const Triangle_coefficients coefficients = triangle_coefficients(metric(*c / 3));
        const Row_entries values = row_entries(mesh, coefficients, value_weights, *c);
        weight += values.vv + values.va + values.vb;
        if(row_entries(mesh, coefficients, m_weights, *c).vv != 0)
          is_at_rest[v] = 0;
      }
      const int component = components.of_vertex[v];
      mass[component] += weight;
      moment.row(component) += weight * displacement.row(v);
      if(m_unknowns.of_vertex[v] < 0)
        is_held[component] = 1;
    }
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
    {
      const int component = components.of_vertex[v];
      if(!is_held[component] && !is_at_rest[v] && mass[component] > 0)
        displacement.row(v) -= moment.row(component) / mass[component];
    }
  }

  Eigen::MatrixXd multiply(const Eigen::MatrixXd& x) const
  {
    if(m_solver.reads_lower_triangle)
      return m_unshifted.selfadjointView<Eigen::Lower>() * x;
    return m_unshifted * x;
  }

  // Whether a component has neither a constrained vertex nor a value weight to hold it.
  bool has_floating_component() const
  {
    if(m_weights.value_at_vertex.empty() && m_weights.value > 0)
      return false;
    std::vector<int> parent(mesh.number_of_vertices());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int v) {
      while(parent[v] != v)
        v = parent[v] = parent[parent[v]];
      return v;
    };
    for(int f = 0; f < mesh.number_of_triangles(); ++f)
      if(m_weights.gradient_at(f) > 0)
        for(int i = 1; i < 3; ++i)
          parent[root(mesh.triangles[f][i])] = root(mesh.triangles[f][0]);

    std::vector<char> is_held(parent.size(), 0), is_stiff(parent.size(), 0);
    for(int f = 0; f < mesh.number_of_triangles(); ++f)
      for(int v : mesh.triangles[f])
      {
        if(m_weights.gradient_at(f) > 0)
          is_stiff[root(v)] = 1;
        for(int w : mesh.triangles[f])
          if(m_weights.value_at(w) > 0)
            is_held[root(v)] = 1;
      }
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      if(is_constrained[v])
        is_held[root(v)] = 1;
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      if(is_stiff[v] && !is_held[root(v)])
        return true;
    return false;
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_LINEAR_SYSTEM_H
