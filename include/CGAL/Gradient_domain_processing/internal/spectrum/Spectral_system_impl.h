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
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <cstddef>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Channels that are done, or zero, stay as they are.
CGAL_GDP_INLINE Eigen::RowVectorXd quotients(const Eigen::RowVectorXd& a, const Eigen::RowVectorXd& b)
{
  Eigen::RowVectorXd q(a.size());
  for(Eigen::Index i = 0; i < a.size(); ++i)
    q[i] = a[i] > 0 && b[i] > 0 ? a[i] / b[i] : 0;
  return q;
}

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
  const Eigen::MatrixXd weighted = m_masses.asDiagonal() * signal, slopes = times_stiffness(signal);
  Eigen::MatrixXd sum = filter.constant() * signal, right, x;
  double cut_off = 0; // of the factor
  for(const Rational_filter::Fraction& fraction : filter.fractions())
  {
    if(fraction.cut_off != cut_off)
      if(const Error_code code = factorize(fraction.cut_off, progress))
        return code;
    cut_off = fraction.cut_off;
    Stage_scope stage(progress, Stage::SOLVE);
    right = fraction.weight * weighted;
    if(fraction.has_second_degree)
      right -= fraction.weight * fraction.slope / cut_off * slopes;
    if(const Error_code code = fraction.has_second_degree ? solve_second_degree(fraction, progress, right, x)
                                                          : m_solver->solve(right, x, [&] { return progress.go_on(); }))
      return code;
    sum += x;
  }
  if(!sum.allFinite())
    return error_cannot_solve_linear_system;
  signal.swap(sum);
  return ok;
}

CGAL_GDP_INLINE Error_code Spectral_system::factorize(double cut_off, Progress& progress)
{
  if(!progress.go_on())
    return error_cancelled;
  Stage_scope stage(progress, Stage::FACTOR);
  Sparse_matrix matrix;
  if(m_solver->reads_lower_triangle())
    matrix = m_stiffness.triangularView<Eigen::Lower>();
  else
    matrix = m_stiffness;
  matrix /= cut_off;
  for(int i = 0; i < m_dofs.size(); ++i)
    matrix.coeffRef(i, i) += m_masses[i];
  return m_solver->factorize(matrix, [&] { return progress.go_on(); });
}

CGAL_GDP_INLINE Eigen::MatrixXd Spectral_system::times_stiffness(const Eigen::MatrixXd& x) const
{
  Eigen::MatrixXd y(x.rows(), x.cols());
  for_each_block(m_parallel, std::size_t(m_dofs.size()), 4096, [&](std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i)
      for(Eigen::Index channel = 0; channel < x.cols(); ++channel)
      {
        double sum = 0;
        for(Sparse_matrix::InnerIterator it(m_stiffness, Eigen::Index(i)); it; ++it)
          sum += it.value() * x(it.row(), channel);
        y(Eigen::Index(i), channel) = sum;
      }
  });
  return y;
}

CGAL_GDP_INLINE Eigen::MatrixXd Spectral_system::times_second_degree(const Rational_filter::Fraction& fraction,
                                                                     const Eigen::MatrixXd& x) const
{
  const double c = fraction.cut_off;
  Eigen::MatrixXd slopes = times_stiffness(x);
  Eigen::MatrixXd y = m_masses.asDiagonal() * x;
  y += (2 * fraction.shift / c) * slopes;
  slopes = m_masses.cwiseInverse().asDiagonal() * slopes;
  y += times_stiffness(slopes) / (c * c);
  return y;
}

CGAL_GDP_INLINE Error_code Spectral_system::solve_second_degree(const Rational_filter::Fraction& fraction,
                                                                Progress& progress, const Eigen::MatrixXd& right,
                                                                Eigen::MatrixXd& x)
{
  const auto go_on = [&] { return progress.go_on(); };
  const auto products = [](const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) -> Eigen::RowVectorXd {
    return a.cwiseProduct(b).colwise().sum();
  };
  x.setZero(right.rows(), right.cols());
  Eigen::MatrixXd residual = right, z, direction;
  Eigen::RowVectorXd first, last;
  for(int step = 0; step < most_steps; ++step)
  {
    if(const Error_code code = m_solver->solve(residual, z, go_on))
      return code;
    z = m_masses.asDiagonal() * z;
    if(const Error_code code = m_solver->solve(z, z, go_on))
      return code;
    const Eigen::RowVectorXd now = products(residual, z);
    if(step == 0)
      first = now;
    if((now.array() <= tolerance * tolerance * first.array()).all())
      return ok;
    if(step == 0)
      direction = z;
    else
      direction = z + direction * quotients(now, last).asDiagonal();
    last = now;
    const Eigen::MatrixXd image = times_second_degree(fraction, direction);
    const Eigen::RowVectorXd lengths = quotients(now, products(direction, image));
    x += direction * lengths.asDiagonal();
    residual -= image * lengths.asDiagonal();
  }
  return error_not_converged;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_SPECTRAL_SYSTEM_IMPL_H
