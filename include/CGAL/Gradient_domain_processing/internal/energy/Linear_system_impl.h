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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_LINEAR_SYSTEM_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_LINEAR_SYSTEM_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/energy/Linear_system.h>
#include <CGAL/Gradient_domain_processing/internal/energy/assemble.h>
#include <CGAL/Gradient_domain_processing/internal/energy/floating_components.h>
#include <CGAL/Gradient_domain_processing/internal/energy/prolongation.h>
#include <CGAL/Gradient_domain_processing/internal/energy/recenter.h>
#include <CGAL/Gradient_domain_processing/internal/energy/right_hand_side.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/elimination_order.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/turn_to_cholesky.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/number_of_threads.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE Error_code Linear_system::factorize(Progress& progress)
{
  if(m_is_factorized && (m_dofs.size() == 0 || m_solver->has_factor()))
    return ok;
  if(has_floating_component(mesh, m_coefficients.weights,
                            has_second_order() ? m_coefficients.constraints_of_second_order : 0, is_constrained))
    return error_unconstrained;
  if(const Error_code code = analyze(progress))
    return code;
  if(m_dofs.size() > 0)
  {
    if(!progress.go_on())
      return error_cancelled;
    Sparse_matrix matrix; // the solver has a factor or a copy of it, so it need not stay
    {
      Stage_scope stage(progress, Stage::ASSEMBLE);
      matrix.swap(m_matrix);
      assemble_into(matrix);
    }
    if(!progress.go_on())
      return error_cancelled;
    if(!m_is_pattern_analyzed)
    {
      Stage_scope stage(progress, Stage::ANALYZE);
      if(const Error_code code = m_solver->analyze(matrix))
        return code;
      m_is_pattern_analyzed = true;
    }
    Stage_scope stage(progress, Stage::FACTOR);
    if(const Error_code code = factorize_or_shift(matrix, progress))
      return code;
  }
  m_is_factorized = true;
  return ok;
}

template <class Target_field>
Error_code Linear_system::solve_as_it_is(const Target_field& target, Progress& progress, Signal& displacement,
                                         bool displaces_constraints)
{
  if(const Error_code code = factorize(progress))
    return code;
  Eigen::MatrixXd residual;
  if(m_dofs.size() > 0)
  {
    if(!progress.go_on())
      return error_cancelled;
    Stage_scope stage(progress, Stage::ASSEMBLE);
    residual =
      target_residual(mesh, m_coefficients.metrics, m_coefficients.weights, assembled_dofs(), target, parallel);
    if(has_second_order())
      subtract_second_order(target.by_vertex(), residual);
  }
  else
    residual.resize(0, target.channels());
  return solve_residual(residual, progress, displacement, displaces_constraints);
}

template <class Target_field>
Error_code Linear_system::solve(const Target_field& target, Progress& progress, Signal& displacement,
                                bool displaces_constraints)
{
  const Error_code code = solve_as_it_is(target, progress, displacement, displaces_constraints);
  if(code != error_not_converged || !turn_to_cholesky(m_dofs.size(), progress, m_solver))
    return code;
  m_is_analyzed = m_is_factorized = false;
  return solve_as_it_is(target, progress, displacement, displaces_constraints);
}

CGAL_GDP_INLINE Solver_task Linear_system::solver_task(std::size_t number_of_unknowns) const
{
  const Energy_weights& weights = m_coefficients.weights;
  const bool is_known = weights.value_at_vertex.empty() && weights.gradient_at_triangle.empty() && weights.value > 0;
  Solver_task task;
  task.unknowns = number_of_unknowns;
  // where it is not known, one that is large
  task.gradient_weight = is_known ? weights.gradient / (weights.value * mesh.area(parallel)) : 1;
  task.has_metric = !m_coefficients.metrics.given.empty();
  task.is_of_second_order = has_second_order();
  task.cores = number_of_threads(parallel);
  return task;
}

CGAL_GDP_INLINE Error_code Linear_system::analyze(Progress& progress)
{
  if(m_is_analyzed)
    return ok;
  if(!progress.go_on())
    return error_cancelled;
  Stage_scope stage(progress, Stage::ANALYZE);

  const Lists rings = mesh.one_rings(parallel);
  const auto neighbors = [&] {
    const Lists first = has_virtual_vertices() ? rings_of_polygons(rings, mesh) : rings;
    return has_second_order() ? second_rings(first) : first;
  };
  std::vector<char> is_free(mesh.points.size());
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    is_free[v] = !is_constrained[v] && mesh.corners.size(v) > 0 && v < mesh.first_virtual_vertex();
  bool is_cancelled = false;
  m_solver->prepare(solver_task(std::size_t(std::count(is_free.begin(), is_free.end(), 1))));
  if(m_solver->needs_order())
    m_dofs = elimination_order(mesh.points, neighbors(), is_free, parallel,
                               [&] { return !(is_cancelled = !progress.go_on()); });
  else
    m_dofs = numbered_in_memory_order(is_free);
  if(is_cancelled)
    return error_cancelled;
  if(has_virtual_vertices())
    m_dofs_with_virtual_vertices = with_virtual_vertices(m_dofs, mesh);
  const bool is_lower = m_solver->reads_lower_triangle() && !has_own_pattern();
  m_pattern = sparsity_pattern(rings, assembled_dofs(), is_lower, parallel);
  Error_code code = ok;
  if(has_virtual_vertices())
    m_prolongation = prolongation(m_dofs, mesh);
  m_matrix = Sparse_matrix();
  m_is_pattern_analyzed = !has_own_pattern();
  if(m_is_pattern_analyzed)
  {
    set_pattern(m_pattern, parallel, m_matrix);
    code = m_dofs.size() > 0 ? m_solver->analyze(m_matrix) : ok;
  }
  m_is_analyzed = code == ok;
  return code;
}

CGAL_GDP_INLINE void Linear_system::assemble_into(Sparse_matrix& matrix)
{
  if(matrix.rows() == 0)
    set_pattern(m_pattern, parallel, matrix);
  m_values_weigh_little = assemble(mesh, m_coefficients.metrics, m_coefficients.weights, assembled_dofs(), parallel,
                                   matrix, !has_own_pattern());
  if(has_second_order())
  {
    m_second_order = m_coefficients.second_order(mesh, m_coefficients.metrics, parallel);
    matrix += restricted(m_second_order, assembled_dofs());
  }
  if(has_virtual_vertices())
    matrix = Sparse_matrix(m_prolongation.transpose() * Sparse_matrix(matrix * m_prolongation));
  if(has_own_pattern())
    for(int j = 0; j < int(matrix.cols()); ++j)
      if(double& diagonal = matrix.coeffRef(j, j); diagonal == 0)
        diagonal = 1; // what nothing acts on stays where it is
  if(has_own_pattern() && m_solver->reads_lower_triangle())
    matrix = Sparse_matrix(matrix.triangularView<Eigen::Lower>());
}

CGAL_GDP_INLINE void Linear_system::subtract_second_order(const Signal& by_vertex, Eigen::MatrixXd& residual) const
{
  const Eigen::MatrixXd product = m_second_order * by_vertex;
  for_each_degree_of_freedom(parallel, assembled_dofs(), [&](int v, int row) { residual.row(row) -= product.row(v); });
}

CGAL_GDP_INLINE Error_code Linear_system::factorize_or_shift(Sparse_matrix& matrix, Progress& progress)
{
  const auto go_on = [&] { return progress.go_on(); };
  m_unshifted = Sparse_matrix();
  Error_code code = m_solver->factorize(matrix, go_on);
  if(code == ok || code == error_cancelled || m_solver->is_iterative())
    return code;
  m_unshifted = matrix;
  for(int j = 0; j < m_dofs.size(); ++j)
    matrix.coeffRef(j, j) *= 1 + 1e-10;
  return m_solver->factorize(matrix, go_on);
}

CGAL_GDP_INLINE Error_code Linear_system::solve_residual(Eigen::MatrixXd& residual, Progress& progress,
                                                         Signal& displacement, bool displaces_constraints)
{
  const Eigen::Index channels = residual.cols();
  if(displaces_constraints && has_virtual_vertices())
    interpolate_virtual_vertices(mesh, displacement);
  if(m_dofs.size() == 0)
  {
    if(!displaces_constraints)
      displacement.setZero(mesh.number_of_vertices(), channels);
    return ok;
  }
  if(displaces_constraints)
  {
    move_constraints_to_right_hand_side(displacement, residual);
    if(has_second_order())
      subtract_second_order(displacement, residual);
  }
  if(has_virtual_vertices())
    residual = (m_prolongation.transpose() * residual).eval();
  Stage_scope stage(progress, Stage::SOLVE);
  if(const Error_code code = solve_refined(residual, progress))
    return code;
  if(!displaces_constraints) // not before: memory is scarcest in the solver
    displacement.setZero(mesh.number_of_vertices(), channels);
  for_each_degree_of_freedom(parallel, m_dofs, [&](int v, int row) { displacement.row(v) = residual.row(row); });
  if(has_virtual_vertices())
    interpolate_virtual_vertices(mesh, displacement);
  if(m_values_weigh_little)
    recenter(mesh, m_coefficients.metrics, m_coefficients.weights, is_constrained, displacement);
  return displacement.allFinite() ? ok : error_cannot_solve_linear_system;
}

CGAL_GDP_INLINE void Linear_system::move_constraints_to_right_hand_side(const Signal& displacement,
                                                                        Eigen::MatrixXd& residual) const
{
  if(!has_virtual_vertices())
  {
    move_to_right_hand_side(mesh, m_coefficients.metrics, m_coefficients.weights, m_dofs, displacement, parallel,
                            residual);
    return;
  }
  Sparse_matrix matrix;
  set_pattern(sparsity_pattern(mesh.one_rings(parallel), assembled_dofs(), false, parallel), parallel, matrix);
  assemble(mesh, m_coefficients.metrics, m_coefficients.weights, assembled_dofs(), parallel, matrix);
  Eigen::MatrixXd of_virtual = Eigen::MatrixXd::Zero(assembled_dofs().size(), residual.cols());
  for(int v = mesh.first_virtual_vertex(); v < mesh.number_of_vertices(); ++v)
    of_virtual.row(assembled_dofs().of_vertex[v]) = displacement.row(v);
  residual -= matrix * of_virtual;
  move_to_right_hand_side(mesh, m_coefficients.metrics, m_coefficients.weights, assembled_dofs(), displacement,
                          parallel, residual);
}

CGAL_GDP_INLINE Error_code Linear_system::solve_refined(Eigen::MatrixXd& values, Progress& progress)
{
  const auto go_on = [&] { return progress.go_on(); };
  if(m_unshifted.size() == 0)
    return m_solver->solve(values, values, go_on);
  const Eigen::MatrixXd right = values;
  Error_code code = m_solver->solve(right, values, go_on);
  if(code != ok)
    return code;
  Eigen::MatrixXd residual = right - multiply(values), correction;
  for(int step = 0; step < 20; ++step)
  {
    code = m_solver->solve(residual, correction, go_on);
    if(code != ok)
      return code;
    const Eigen::MatrixXd better = values + correction, less = right - multiply(better);
    if(!(less.norm() < residual.norm()))
      break;
    values = better;
    residual = less;
  }
  return residual.norm() <= 1e-4 * right.norm() ? ok : error_cannot_solve_linear_system;
}

CGAL_GDP_INLINE Eigen::MatrixXd Linear_system::multiply(const Eigen::MatrixXd& x) const
{
  if(m_solver->reads_lower_triangle())
    return m_unshifted.selfadjointView<Eigen::Lower>() * x;
  return m_unshifted * x;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_LINEAR_SYSTEM_IMPL_H
