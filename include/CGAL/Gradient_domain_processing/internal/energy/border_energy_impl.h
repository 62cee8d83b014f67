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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_BORDER_ENERGY_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_BORDER_ENERGY_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/energy/border_energy.h>
#include <CGAL/Gradient_domain_processing/Default_sparse_linear_solver.h>
#include <CGAL/Gradient_domain_processing/internal/energy/floating_components.h>
#include <CGAL/Gradient_domain_processing/internal/energy/right_hand_side.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Linear_solver.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/border_edges.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>
#include <utility>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The one-dimensional problem on curves, such as the border: the energy with lengths in place of areas and the
// derivative along the curve in place of the gradient, (alpha M_1 + beta S_1) (g - f) = beta (D_1 v - S_1 f).
class Border_energy
{
  const Indexed_triangles& m_mesh;
  const Energy_weights& m_weights;
  std::vector<Border_edge> m_edges;
  std::vector<double> m_lengths;
  Degrees_of_freedom m_dofs;

public:
  // Only vertices of the edges that are not constrained move.
  Border_energy(const Indexed_triangles& mesh, std::vector<Border_edge> edges, const Energy_weights& weights,
                const std::vector<char>& is_constrained)
    : m_mesh(mesh), m_weights(weights), m_edges(std::move(edges))
  {
    double longest = 0;
    std::vector<char> is_free(mesh.points.size(), 0);
    for(const Border_edge& e : m_edges)
    {
      const auto& t = mesh.triangles[e.triangle];
      m_lengths.push_back((mesh.points[t[e.from]] - mesh.points[t[e.to]]).norm());
      longest = (std::max)(longest, m_lengths.back());
      for(int v : {t[e.from], t[e.to]})
        is_free[v] = !is_constrained[v];
    }
    for(double& length : m_lengths)
      length = (std::max)(length, degeneracy_ratio * longest);
    m_dofs = numbered_in_memory_order(is_free); // curves fill in alike in any order
  }

  const std::vector<Border_edge>& edges() const { return m_edges; }

  // The change of these vertices, in their rows of `displacement`; the others stay.
  template <class Target_field>
  Error_code displace(const Target_field& target, Signal& displacement) const
  {
    if(m_dofs.size() == 0)
      return ok;
    Eigen::MatrixXd residual = Eigen::MatrixXd::Zero(m_dofs.size(), target.channels());
    Any_channels along(target.channels());
    for(std::size_t e = 0; e < m_edges.size(); ++e)
      for(bool is_reversed : {false, true})
      {
        const int from = is_reversed ? m_edges[e].to : m_edges[e].from,
                  to = is_reversed ? m_edges[e].from : m_edges[e].to;
        const int row = m_dofs.of_vertex[m_mesh.triangles[m_edges[e].triangle][from]];
        if(row < 0)
          continue;
        target.residual(m_edges[e].triangle, from, to, along);
        for(int channel = 0; channel < along.size(); ++channel)
          residual(row, channel) -= stiffness(e) * along[channel];
      }
    if(const Error_code code = solve(residual))
      return code;
    for(int i = 0; i < m_dofs.size(); ++i)
      displacement.row(m_dofs.vertex[i]) = residual.row(i);
    return ok;
  }

private:
  double stiffness(std::size_t e) const { return m_weights.gradient_at(m_edges[e].triangle) / m_lengths[e]; }

  Sparse_matrix matrix() const
  {
    std::vector<Eigen::Triplet<double> > entries; // a border is short
    std::vector<char> is_at_rest(m_dofs.vertex.size(), 1);
    for(std::size_t e = 0; e < m_edges.size(); ++e)
    {
      const auto& t = m_mesh.triangles[m_edges[e].triangle];
      const int ends[2] = {t[m_edges[e].from], t[m_edges[e].to]};
      for(int i = 0; i < 2; ++i)
      {
        const int row = m_dofs.of_vertex[ends[i]], column = m_dofs.of_vertex[ends[1 - i]];
        if(row < 0)
          continue;
        // the integral of alpha phi_v phi_x with alpha linear on the edge
        const double here = m_weights.value_at(ends[i]), there = m_weights.value_at(ends[1 - i]);
        const double diagonal = m_lengths[e] * (here / 4 + there / 12) + stiffness(e);
        entries.emplace_back(row, row, diagonal);
        if(diagonal != 0)
          is_at_rest[row] = 0;
        if(column >= 0)
          entries.emplace_back(row, column, m_lengths[e] * (here + there) / 12 - stiffness(e));
      }
    }
    for(int i = 0; i < m_dofs.size(); ++i)
      if(is_at_rest[i])
        entries.emplace_back(i, i, 1.);
    Sparse_matrix result(m_dofs.size(), m_dofs.size());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  Error_code solve(Eigen::MatrixXd& residual) const
  {
    const Sparse_matrix a = matrix();
    Linear_solver<Default_sparse_linear_solver> solver((Default_sparse_linear_solver()));
    if(const Error_code code = solver.factorize(a))
      return code;
    return solver.solve(residual, residual);
  }
};

template <class Target_field>
Error_code displace_curves(const Indexed_triangles& mesh, std::vector<Border_edge> edges, const Energy_weights& weights,
                           const std::vector<char>& is_constrained, const Target_field& target, Signal& displacement)
{
  const Border_energy energy(mesh, std::move(edges), weights, is_constrained);
  if(has_floating_border(mesh, energy.edges(), weights, is_constrained))
    return error_unconstrained;
  return energy.displace(target, displacement);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_BORDER_ENERGY_IMPL_H
