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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_CURVED_HESSIAN_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_CURVED_HESSIAN_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/higher_order/curved_hessian.h>
#include <CGAL/Gradient_domain_processing/Triangle_metric.h>
#include <CGAL/Gradient_domain_processing/internal/energy/element_matrices.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/Element_matrices.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/edge_neighbors.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/shared_lengths.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_for.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The Hessian energy of Stein, Jacobson, Wardetzky and Grinspun 2020, Q = G^T M^-1 (L + K) M^-1 G, without the
// matrices: the gradient at the middle of an edge is the mean of those of its two triangles, unfolded about it and
// weighted by area (M^-1 G); on every triangle these three make a linear field V, and Q sums up |grad V|^2 (L) and, at
// the corners, the Gaussian curvature times |V|^2 (K). No condition is imposed at borders, so that functions that are
// linear on a plane cost nothing. Without K it is the squared Hessian itself, semidefinite under every metric; Q is
// not, where a surface of negative curvature has a border. Without half the squared divergence of V as well, it is the
// trace-free part of the Hessian.
class Curved_hessian
{
  const Indexed_triangles& m_mesh;
  std::vector<int> m_neighbors;
  std::vector<Triangle_metric> m_metrics;
  Hessian_kind m_kind;

  // A linear function of the values of an element's vertices: three of the triangle, three across its edges.
  typedef std::array<double, 6> Row;

public:
  Curved_hessian(const Indexed_triangles& mesh, const Triangle_metrics& metrics, Hessian_kind kind, bool parallel)
    : m_mesh(mesh), m_neighbors(edge_neighbors(mesh, parallel)),
      m_metrics(with_shared_lengths(mesh, metrics, m_neighbors, parallel)), m_kind(kind)
  {}

  Eigen::SparseMatrix<double> matrix(bool parallel) const
  {
    Element_matrices elements(stencils());
    parallel_for(parallel, m_mesh.triangles.size(), [&](std::size_t f) { set_element(int(f), elements); });
    return elements.sum(m_mesh.number_of_vertices(), parallel);
  }

private:
  // Those across an edge follow the triangle's own, where there are any.
  Lists stencils() const
  {
    Lists lists;
    lists.offsets.reserve(m_mesh.triangles.size() + 1);
    lists.items.reserve(6 * m_mesh.triangles.size());
    lists.offsets.push_back(0);
    for(std::size_t f = 0; f < m_mesh.triangles.size(); ++f)
    {
      const auto& t = m_mesh.triangles[f];
      lists.items.insert(lists.items.end(), t.begin(), t.end());
      for(std::size_t i = 0; i < 3; ++i)
        if(const int across = m_neighbors[3 * f + i]; across >= 0)
          lists.items.push_back(vertex(across));
      lists.offsets.push_back(int(lists.items.size()));
    }
    return lists;
  }

  int vertex(int corner) const { return m_mesh.triangles[std::size_t(corner / 3)][std::size_t(corner % 3)]; }

  // Adds weight times the gradient on the triangle of a corner, along the opposite edge, to the second vertex of it
  // from the first, and across it, to the corner; the three vertices have these places in the rows.
  void add_gradient(int corner, double weight, std::array<std::size_t, 3> place, Row& along, Row& across) const
  {
    const Triangle_metric& metric = m_metrics[std::size_t(corner / 3)];
    const int i = corner % 3, j = (i + 1) % 3, k = (i + 2) % 3;
    const double shortest = degeneracy_ratio * std::sqrt(metric.max_squared_length());
    const double length = (std::max)(std::sqrt(squared_length(metric, i)), shortest);
    along[place[2]] += weight / length;
    along[place[1]] -= weight / length;
    const double to_height = weight / (length * metric.sqrt_determinant());
    const double from_j = metric.corner_product(k) * to_height, from_k = metric.corner_product(j) * to_height;
    across[place[0]] += from_j + from_k;
    across[place[1]] -= from_j;
    across[place[2]] -= from_k;
  }

  // The gradient at the middle of the edge opposite to a corner, in the frame of the triangle at that edge.
  void set_edge_gradient(int corner, std::size_t place_across, Row& along, Row& across) const
  {
    const std::size_t i = std::size_t(corner % 3), j = (i + 1) % 3, k = (i + 2) % 3;
    const int other = m_neighbors[std::size_t(corner)];
    const double area = m_metrics[std::size_t(corner / 3)].area();
    const double area_across = other < 0 ? 0 : m_metrics[std::size_t(other / 3)].area();
    along.fill(0);
    across.fill(0);
    add_gradient(corner, area / (area + area_across), {{i, j, k}}, along, across);
    if(!(area_across > 0))
      return;
    Row other_along = {}, other_across = {};
    const bool same_direction = m_mesh.opposite_vertices(other)[0] == m_mesh.opposite_vertices(corner)[0];
    add_gradient(other, area_across / (area + area_across),
                 {{place_across, same_direction ? j : k, same_direction ? k : j}}, other_along, other_across);
    for(std::size_t p = 0; p < 6; ++p)
    {
      along[p] += same_direction ? other_along[p] : -other_along[p];
      across[p] -= other_across[p];
    }
  }

  // The Gaussian curvature at a corner of a triangle: its share, by angle, of what is missing to a full turn around the
  // vertex. The triangles that are connected around the vertex count; if they do not close, it is a border, which has
  // none.
  double corner_curvature(int corner) const
  {
    const int v = vertex(corner);
    double turn = 0;
    int at = corner, into = corner % 3; // the corner of v, and that from whose opposite edge we came
    do
    {
      const int f = at / 3;
      turn += angle(at);
      const int away = into == at % 3 ? (into + 1) % 3 : 3 - into - at % 3;
      const int other = m_neighbors[std::size_t(3 * f + away)];
      if(other < 0)
        return 0;
      into = other % 3;
      at = 3 * (other / 3);
      while(vertex(at) != v)
        ++at;
    } while(at / 3 != corner / 3);
    const double full_turn = 8 * std::atan(1.);
    return turn > 0 ? (full_turn - turn) / turn * angle(corner) : 0;
  }

  double angle(int corner) const
  {
    const Triangle_metric& metric = m_metrics[std::size_t(corner / 3)];
    return std::atan2(metric.sqrt_determinant(), metric.corner_product(corner % 3));
  }

  // The weights of <V_i, V_j> with V_i at the middle of the edge opposite to corner i.
  std::array<double, 9> field_weights(int f) const
  {
    const Triangle_metric& metric = m_metrics[std::size_t(f)];
    std::array<double, 9> weights;
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        weights[std::size_t(3 * i + j)] =
          i == j ? 4 * (half_cotangent(metric, (i + 1) % 3) + half_cotangent(metric, (i + 2) % 3))
                 : -4 * half_cotangent(metric, 3 - i - j);
    // V at corner v: the sum of its two edges', minus that of the third
    for(int v = 0; v < 3 && m_kind == Hessian_kind::CURVED_HESSIAN; ++v)
    {
      const double curvature = corner_curvature(3 * f + v);
      for(int i = 0; i < 3; ++i)
        for(int j = 0; j < 3; ++j)
          weights[std::size_t(3 * i + j)] += (i == v) == (j == v) ? curvature : -curvature;
    }
    return weights;
  }

  // The directions of the three edges in the plane of the triangle, the first along the first axis.
  std::array<std::array<double, 2>, 3> directions(int f) const
  {
    const Triangle_metric& metric = m_metrics[std::size_t(f)];
    const double w = metric.sqrt_determinant(), c1 = metric.corner_product(1), c2 = metric.corner_product(2);
    const double at_1 = std::hypot(c1, w), at_2 = std::hypot(c2, w);
    return {{{{1, 0}}, {{-c2 / at_2, w / at_2}}, {{-c1 / at_1, -w / at_1}}}};
  }

  void set_element(int f, Element_matrices& elements) const
  {
    const int size = elements.size(f);
    for(int p = 0; p < size; ++p)
      for(int q = 0; q <= p; ++q)
        elements.value(f, p, q) = 0;
    if(!(m_metrics[std::size_t(f)].sqrt_determinant() > 0))
      return;

    std::array<Row, 3> x, y; // of the field at the middles, in one frame
    Row divergence = {};     // times half of w
    const auto direction = directions(f);
    std::size_t place_across = 3;
    for(std::size_t i = 0; i < 3; ++i)
    {
      Row along, across;
      const int corner = 3 * f + int(i);
      set_edge_gradient(corner, place_across, along, across);
      if(m_neighbors[std::size_t(corner)] >= 0)
        ++place_across;
      const double length = std::sqrt(squared_length(m_metrics[std::size_t(f)], int(i)));
      for(std::size_t p = 0; p < 6; ++p)
      {
        divergence[p] -= length * across[p];
        x[i][p] = direction[i][0] * along[p] - direction[i][1] * across[p];
        y[i][p] = direction[i][1] * along[p] + direction[i][0] * across[p];
      }
    }
    const std::array<double, 9> weights = field_weights(f);
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j = 0; j < 3; ++j)
        for(int p = 0; p < size; ++p)
          for(int q = 0; q <= p; ++q)
            elements.value(f, p, q) += weights[3 * i + j] * (x[i][std::size_t(p)] * x[j][std::size_t(q)]
                                                           + y[i][std::size_t(p)] * y[j][std::size_t(q)]);
    if(m_kind != Hessian_kind::TRACE_FREE_HESSIAN)
      return;
    for(int p = 0; p < size; ++p)
      for(int q = 0; q <= p; ++q)
        elements.value(f, p, q) -=
          divergence[std::size_t(p)] * divergence[std::size_t(q)] / m_metrics[std::size_t(f)].sqrt_determinant();
  }
};

CGAL_GDP_INLINE Eigen::SparseMatrix<double> curved_hessian(const Indexed_triangles& mesh,
                                                           const Triangle_metrics& metrics, Hessian_kind kind,
                                                           bool parallel)
{
  return Curved_hessian(mesh, metrics, kind, parallel).matrix(parallel);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_CURVED_HESSIAN_IMPL_H
