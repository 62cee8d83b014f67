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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_ELEMENT_MATRICES_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_ELEMENT_MATRICES_H

#include <CGAL/Gradient_domain_processing/internal/energy/Energy_weights.h>
#include <CGAL/Gradient_domain_processing/internal/metric/Triangle_metrics.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The stiffness of a triangle (A.4): minus its entry for the edge opposite to a corner is half the cotangent of the
// corner. A triangle shrunk to a point has none.
inline double half_cotangent(const Triangle_metric& metric, int corner)
{
  const double w = metric.sqrt_determinant();
  return w > 0 ? metric.corner_product(corner) / (2 * w) : 0;
}

// What a triangle gives to the matrices: the square root of its metric's determinant, twice the area, and its half
// cotangents.
struct Triangle_coefficients
{
  double sqrt_determinant;
  std::array<double, 3> half_cotangents;
};

inline Triangle_coefficients triangle_coefficients(const Triangle_metric& metric)
{
  return {metric.sqrt_determinant(),
          {{half_cotangent(metric, 0), half_cotangent(metric, 1), half_cotangent(metric, 2)}}};
}

// The coefficients for a block of vertices, each computed once instead of for every corner: those of the triangles
// whose lowest vertex is in the block lie together and are kept; the few others are computed when asked for.
class Block_coefficients
{
  const Indexed_triangles& m_mesh;
  const Triangle_metrics& m_metrics;
  int m_first;
  std::vector<Triangle_coefficients> m_kept;

public:
  Block_coefficients(const Indexed_triangles& mesh, const Triangle_metrics& metrics, std::size_t begin, std::size_t end)
    : m_mesh(mesh), m_metrics(metrics), m_first(first_triangle(begin))
  {
    const int last = first_triangle(end);
    for(int f = m_first; f < last; ++f)
      m_kept.push_back(triangle_coefficients(metrics(mesh, f)));
  }

  Triangle_coefficients operator()(int f) const
  {
    const std::size_t at = std::size_t(f) - std::size_t(m_first); // huge below the first
    return at < m_kept.size() ? m_kept[at] : triangle_coefficients(m_metrics(m_mesh, f));
  }

private:
  // Of those whose vertices are all at least v; triangles are sorted by their lowest vertex.
  int first_triangle(std::size_t v) const
  {
    const auto is_below = [v](const std::array<int, 3>& t) {
      return std::size_t(*std::min_element(t.begin(), t.end())) < v;
    };
    return int(std::partition_point(m_mesh.triangles.begin(), m_mesh.triangles.end(), is_below)
               - m_mesh.triangles.begin());
  }
};

// What a triangle adds to the row of one of its vertices v in alpha M + beta S (A.1, A.4): to the entries (v,v), (v,a),
// (v,b), where a and b are the next two vertices of the triangle.
struct Row_entries
{
  double vv, va, vb;
};

inline Row_entries row_entries(const Indexed_triangles& mesh, const Triangle_coefficients& coefficients,
                               const Energy_weights& weights, int corner)
{
  const int f = corner / 3, i = corner % 3, j = (i + 1) % 3, k = (i + 2) % 3;
  const double beta = weights.gradient_at(f);
  const double to_a = beta * coefficients.half_cotangents[k], to_b = beta * coefficients.half_cotangents[j];

  const double w = coefficients.sqrt_determinant;
  if(weights.value_at_vertex.empty())
  {
    const double mass = weights.value * w / 24;
    return {2 * mass + to_a + to_b, mass - to_a, mass - to_b};
  }

  // the integral of alpha phi_v phi_x with alpha linear on the triangle
  const auto& t = mesh.triangles[f];
  const double at_v = weights.value_at_vertex[t[i]], at_a = weights.value_at_vertex[t[j]],
               at_b = weights.value_at_vertex[t[k]];
  return {w / 60 * (3 * at_v + at_a + at_b) + to_a + to_b,
          w / 120 * (2 * at_v + 2 * at_a + at_b) - to_a,
          w / 120 * (2 * at_v + at_a + 2 * at_b) - to_b};
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_ELEMENT_MATRICES_H
