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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_SPECTRAL_SYSTEM_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_SPECTRAL_SYSTEM_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/spectrum/Spectral_system.h>
#include <CGAL/Gradient_domain_processing/internal/energy/assemble.h>
#include <CGAL/Gradient_domain_processing/internal/energy/prolongation.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/bilaplacian.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/elimination_order.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/turn_to_cholesky.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/number_of_threads.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE Error_code Spectral_system::assemble_matrices(const Indexed_triangles& mesh,
                                                              const Triangle_metrics& metrics,
                                                              const std::vector<char>& is_constrained,
                                                              Progress& progress)
{
  if(!progress.go_on())
    return error_cancelled;
  Stage_scope stage(progress, Stage::ASSEMBLE);
  const Lists rings = mesh.one_rings(m_parallel);
  const bool has_virtual_vertices = mesh.virtual_vertices.size() > 0;
  const std::vector<double> masses = lumped_masses(mesh, metrics, m_parallel);
  std::vector<char> is_free(mesh.points.size());
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    is_free[v] = !is_constrained[v] && masses[std::size_t(v)] > 0 && v < mesh.first_virtual_vertex();
  Solver_task task;
  task.unknowns = std::size_t(std::count(is_free.begin(), is_free.end(), 1));
  task.solutions_of_each = 50;
  task.cores = number_of_threads(m_parallel);
  m_solver->prepare(task);
  bool is_cancelled = false;
  m_dofs = elimination_order(mesh.points, has_virtual_vertices ? rings_of_polygons(rings, mesh) : rings, is_free,
                             m_parallel, [&] { return !(is_cancelled = !progress.go_on()); });
  if(is_cancelled)
    return error_cancelled;

  const Degrees_of_freedom all = has_virtual_vertices ? with_virtual_vertices(m_dofs, mesh) : m_dofs;
  Energy_weights weights;
  weights.value = 0;
  weights.gradient = 1;
  set_pattern(sparsity_pattern(rings, all, false, m_parallel), m_parallel, m_stiffness);
  assemble(mesh, metrics, weights, all, m_parallel, m_stiffness, false);
  m_masses.resize(all.size());
  for(int i = 0; i < all.size(); ++i)
    m_masses[i] = masses[std::size_t(all.vertex[std::size_t(i)])];
  if(has_virtual_vertices)
  {
    const Sparse_matrix p = prolongation(m_dofs, mesh);
    m_stiffness = Sparse_matrix(p.transpose() * Sparse_matrix(m_stiffness * p));
    m_masses = (p.transpose() * m_masses).eval();
  }
  return ok;
}

CGAL_GDP_INLINE Error_code Spectral_system::apply(const Rational_filter& filter, Progress& progress,
                                                  Eigen::MatrixXd& signal)
{
  const Error_code code = apply_as_it_is(filter, progress, signal);
  if(code != error_not_converged || !turn_to_cholesky(m_dofs.size(), progress, m_solver))
    return code;
  return apply_as_it_is(filter, progress, signal);
}

CGAL_GDP_INLINE Error_code Spectral_system::apply_as_it_is(const Rational_filter& filter, Progress& progress,
                                                           Eigen::MatrixXd& signal)
{
  Eigen::MatrixXd sum = filter.constant() * signal;
  for(const Chebyshev_series& series : filter.series())
  {
    if(const Error_code code = factorize(series.center(), progress))
      return code;
    if(const Error_code code = add(series, progress, signal, sum))
      return code;
  }
  if(!sum.allFinite())
    return error_cannot_solve_linear_system;
  signal.swap(sum);
  return ok;
}

CGAL_GDP_INLINE Error_code Spectral_system::factorize(double center, Progress& progress)
{
  if(!progress.go_on())
    return error_cancelled;
  Stage_scope stage(progress, Stage::FACTOR);
  Sparse_matrix matrix;
  if(m_solver->reads_lower_triangle())
    matrix = m_stiffness.triangularView<Eigen::Lower>();
  else
    matrix = m_stiffness;
  matrix /= center;
  for(int i = 0; i < m_dofs.size(); ++i)
    matrix.coeffRef(i, i) += m_masses[i];
  return m_solver->factorize(matrix, [&] { return progress.go_on(); });
}

CGAL_GDP_INLINE Error_code Spectral_system::add(const Chebyshev_series& series, Progress& progress,
                                                const Eigen::MatrixXd& signal, Eigen::MatrixXd& sum)
{
  Stage_scope stage(progress, Stage::SOLVE);
  Eigen::MatrixXd last, now = signal, next;
  sum += series.coefficients()[0] * now;
  for(int degree = 1; degree <= series.degree(); ++degree)
  {
    next = m_masses.asDiagonal() * now;
    if(const Error_code code = m_solver->solve(next, next, [&] { return progress.go_on(); }))
      return code;
    next = now - 2 * next;
    if(degree > 1)
      next = 2 * next - last;
    sum += series.coefficients()[std::size_t(degree)] * next;
    last.swap(now);
    now.swap(next);
  }
  return ok;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_SPECTRAL_SYSTEM_IMPL_H
