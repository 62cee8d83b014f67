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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_POSITION_FIT_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_POSITION_FIT_H

#include <CGAL/Gradient_domain_processing/internal/denoising/conjugate_gradients.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/constants.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Equation 1 of the paper for positions, with every triangle equilateral and of edge length one: the values are the
// input's, the target gradients the part of the current ones that is tangential to given normals. Solved for the change
// of the current positions, divided by the half_cotangent of such a triangle: an edge then weighs as many times as it
// has triangles.
class Position_fit
{
  const Indexed_triangles& m_mesh;
  Lists m_rings;
  std::vector<float> m_edge_weights; // along m_rings
  std::vector<float> m_value_weights, m_diagonal, m_inverse_diagonal;
  std::vector<Vec3f> m_right, m_change;
  Conjugate_gradients<Vec3f> m_solver;
  bool m_parallel;

public:
  Position_fit(const Indexed_triangles& mesh, const Lists& rings, bool parallel)
    : m_mesh(mesh), m_rings(rings), m_edge_weights(m_rings.items.size(), 0), m_value_weights(mesh.points.size())
    , m_diagonal(mesh.points.size(), 0), m_inverse_diagonal(mesh.points.size()), m_right(mesh.points.size())
    , m_change(mesh.points.size()), m_solver(parallel), m_parallel(parallel)
  {
    parallel_for(parallel, mesh.points.size(), [&](std::size_t v) {
      const int* const first = m_rings.begin(int(v));
      for(const int* c = mesh.corners.begin(int(v)); c != mesh.corners.end(int(v)); ++c)
        for(int w : mesh.opposite_vertices(*c))
          m_edge_weights[m_rings.offsets[v] + (std::find(first, m_rings.end(int(v)), w) - first)] += 1;
      m_diagonal[v] = 2.f * float(mesh.corners.size(int(v)));
    });
  }

  // value_weight(v) for a unit of area; a vertex that may not move is no degree of freedom.
  template <class Value_weight, class May_move>
  void set_weights(const Value_weight& value_weight, const May_move& may_move)
  {
    const double mass = std::sqrt(3.) / 4 / 3, half_cotangent = 0.5 / std::sqrt(3.);
    parallel_for(m_parallel, m_value_weights.size(), [&](std::size_t v) {
      m_value_weights[v] = float(value_weight(int(v)) * mass * m_mesh.corners.size(int(v)) / half_cotangent);
      const float diagonal = m_value_weights[v] + m_diagonal[v];
      m_inverse_diagonal[v] = may_move(int(v)) && diagonal > 0 ? 1 / diagonal : 0;
    });
  }

  void operator()(const std::vector<Vec3>& input, const std::vector<Vec3>& normals, std::vector<Vec3>& points)
  {
    parallel_for(m_parallel, points.size(), [&](std::size_t v) {
      Vec3 right = double(m_value_weights[v]) * (input[v] - points[v]);
      for(const int* c = m_mesh.corners.begin(int(v)); c != m_mesh.corners.end(int(v)); ++c)
      {
        const auto others = m_mesh.opposite_vertices(*c);
        const Vec3& n = normals[*c / 3];
        right += n.dot(points[others[0]] + points[others[1]] - 2 * points[v]) * n;
      }
      m_right[v] = single(right);
      m_change[v] = Vec3f(0, 0, 0, 0);
    });
    m_solver([&](const std::vector<Vec3f>& p, int v) {
      Vec3f product = m_value_weights[v] * p[v];
      for(int k = m_rings.offsets[v]; k < m_rings.offsets[v + 1]; ++k)
        product += m_edge_weights[k] * (p[v] - p[m_rings.items[k]]);
      return product;
    }, m_inverse_diagonal, m_right, denoising::position_tolerance, denoising::most_solver_steps, m_change);
    parallel_for(m_parallel, points.size(), [&](std::size_t v) {
      if(m_inverse_diagonal[v] != 0)
        points[v] += as_double(m_change[v]);
    });
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_POSITION_FIT_H
