// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_ASSEMBLY_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_ASSEMBLY_H

#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/Degrees_of_freedom.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/Untouched_vector.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_for.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

typedef Eigen::SparseMatrix<double> Sparse_matrix;

// The metric of every face. That of the embedding is computed when asked for: it costs no more than to be read, and no memory.
struct Triangle_metrics
{
  Untouched_vector<Triangle_metric> given; // none: the embedding

  Triangle_metric operator()(const Indexed_triangles& mesh, int f) const
  {
    return given.empty() ? mesh.embedding_metric(f).with_area_bounded_below(degeneracy_ratio) : given[f];
  }
};

// alpha, beta and lambda of the energy. The vectors are empty where a weight is the same everywhere.
struct Weights
{
  double value = 1;
  double gradient = 0;
  double scale = 0;
  std::vector<double> value_at_vertex;
  std::vector<double> gradient_at_face;
  std::vector<double> scale_at_face;

  double value_at(int v) const { return value_at_vertex.empty() ? value : value_at_vertex[v]; }
  double gradient_at(int f) const { return gradient_at_face.empty() ? gradient : gradient_at_face[f]; }
  double scale_at(int f) const { return scale_at_face.empty() ? scale : scale_at_face[f]; }
};

// The edge weights of a triangle's stiffness: conductance(i) is minus its entry for the edge opposite to corner i, half a
// cotangent. A triangle shrunk to a point has none.
inline double conductance(const Triangle_metric& metric, int corner)
{
  const double w = metric.sqrt_determinant();
  return w > 0 ? metric.corner_product(corner) / (2 * w) : 0;
}

// What a triangle gives to the matrices: the square root of its metric's determinant, twice the area, and its conductances.
struct Triangle_coefficients
{
  double sqrt_determinant;
  std::array<double, 3> conductances;
};

inline Triangle_coefficients triangle_coefficients(const Triangle_metric& metric)
{
  return {metric.sqrt_determinant(), {{conductance(metric, 0), conductance(metric, 1), conductance(metric, 2)}}};
}

// The coefficients for a block of vertices, each computed once instead of for every corner: those of the triangles whose lowest
// vertex is in the block lie together and are kept; the few others are computed when asked for.
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
    const auto is_below = [v](const std::array<int, 3>& t) { return std::size_t(*std::min_element(t.begin(), t.end())) < v; };
    return int(std::partition_point(m_mesh.triangles.begin(), m_mesh.triangles.end(), is_below) - m_mesh.triangles.begin());
  }
};

// What a triangle adds to the row of one of its vertices v in alpha M + beta S: to the entries (v,v), (v,a), (v,b), where a and
// b are the next two vertices of the triangle.
struct Row_entries
{
  double vv, va, vb;
};

inline Row_entries row_entries(const Indexed_triangles& mesh, const Triangle_coefficients& coefficients, const Weights& weights, int corner)
{
  const int f = corner / 3, i = corner % 3, j = (i + 1) % 3, k = (i + 2) % 3;
  const double beta = weights.gradient_at(f);
  const double to_a = beta * coefficients.conductances[k], to_b = beta * coefficients.conductances[j];

  const double w = coefficients.sqrt_determinant;
  if(weights.value_at_vertex.empty())
  {
    const double mass = weights.value * w / 24;
    return {2 * mass + to_a + to_b, mass - to_a, mass - to_b};
  }

  // the integral of alpha phi_v phi_x with alpha linear on the triangle
  const auto& t = mesh.triangles[f];
  const double at_v = weights.value_at_vertex[t[i]], at_a = weights.value_at_vertex[t[j]], at_b = weights.value_at_vertex[t[k]];
  return {w / 60 * (3 * at_v + at_a + at_b) + to_a + to_b,
          w / 120 * (2 * at_v + 2 * at_a + at_b) - to_a,
          w / 120 * (2 * at_v + at_a + 2 * at_b) - to_b};
}

// body(v, column, coefficients) for all unknowns, in the order of the mesh.
template <class Body>
void for_each_degree_of_freedom(bool parallel, const Degrees_of_freedom& unknowns, const Indexed_triangles& mesh, const Triangle_metrics& metrics, const Body& body)
{
  for_each_block(parallel, unknowns.of_vertex.size(), 1024, [&](std::size_t begin, std::size_t end) {
    const Block_coefficients coefficients(mesh, metrics, begin, end);
    for(std::size_t v = begin; v < end; ++v)
      if(unknowns.of_vertex[v] >= 0)
        body(int(v), unknowns.of_vertex[v], coefficients);
  });
}

// The sparsity pattern of alpha M + beta S, the rows of every column in increasing order: all of them, or those of the lower triangle.
inline Lists sparsity_pattern(const Lists& rings, const Degrees_of_freedom& unknowns, bool lower_only, bool parallel)
{
  const int n = unknowns.size();
  const auto is_in = [&](int row, int column) { return row > column || (row >= 0 && !lower_only); };
  Lists pattern;
  pattern.offsets.assign(n + 1, 0);
  for_each_degree_of_freedom(parallel, unknowns, [&](int v, int j) {
    pattern.offsets[j + 1] = 1 + int(std::count_if(rings.begin(v), rings.end(v), [&](int w) {
      return is_in(unknowns.of_vertex[w], j);
    }));
  });
  for(int j = 0; j < n; ++j)
    pattern.offsets[j + 1] += pattern.offsets[j];
  pattern.items.resize(pattern.offsets[n]);
  for_each_degree_of_freedom(parallel, unknowns, [&](int v, int j) {
    int* const first = pattern.items.data() + pattern.offsets[j];
    int* last = first;
    *last++ = j;
    for(const int* w = rings.begin(v); w != rings.end(v); ++w)
      if(is_in(unknowns.of_vertex[*w], j))
        *last++ = unknowns.of_vertex[*w];
    std::sort(first, last);
  });
  return pattern;
}

// Makes it a square matrix with this pattern, its values still to be set.
inline void set_pattern(const Lists& pattern, bool parallel, Sparse_matrix& matrix)
{
  matrix.resize(pattern.size(), pattern.size());
  matrix.resizeNonZeros(pattern.offsets.back());
  std::copy(pattern.offsets.begin(), pattern.offsets.end(), matrix.outerIndexPtr());
  for_each_block(parallel, pattern.items.size(), 1 << 16, [&](std::size_t begin, std::size_t end) { // most of it is the first touch of memory
    std::copy(pattern.items.data() + begin, pattern.items.data() + end, matrix.innerIndexPtr() + begin);
  });
}

// Fills the values of alpha M + beta S into its pattern, a column at a time: columns do not touch each other. Answers whether
// rounding might decide on the constant of a component: the sum of a row, which holds the values' part, is all but lost in its
// diagonal.
inline bool assemble(const Indexed_triangles& mesh, const Triangle_metrics& metrics, const Weights& weights,
                     const Degrees_of_freedom& unknowns, bool parallel, Sparse_matrix& matrix, bool is_system = true)
{
  std::atomic<bool> values_weigh_little(false);
  const int* const offsets = matrix.outerIndexPtr();
  const int* const rows = matrix.innerIndexPtr();
  double* const values = matrix.valuePtr();
  for_each_degree_of_freedom(parallel, unknowns, mesh, metrics, [&](int v, int j, const Block_coefficients& coefficients) {
    const int first = offsets[j], last = offsets[j + 1];
    std::fill(values + first, values + last, 0.);
    double sum = 0, diagonal = 0;
    const auto add = [&](int row, double value) {
      if(row >= 0)
        sum += value;
      for(int at = first; at < last; ++at) // not found: in the other triangle of the matrix, or no unknown
        if(rows[at] == row)
        {
          values[at] += value;
          return;
        }
    };
    for(const int* c = mesh.corners.begin(v); c != mesh.corners.end(v); ++c)
    {
      const Row_entries entries = row_entries(mesh, coefficients(*c / 3), weights, *c);
      const auto others = mesh.opposite_vertices(*c);
      diagonal += entries.vv;
      add(unknowns.of_vertex[others[0]], entries.va);
      add(unknowns.of_vertex[others[1]], entries.vb);
    }
    // in a system to be solved, a vertex that nothing acts on stays where it is
    add(j, is_system && diagonal == 0 ? 1. : diagonal);
    if(sum < 1e-9 * diagonal)
      values_weigh_little.store(true, std::memory_order_relaxed);
  });
  return values_weigh_little;
}

// beta (D v - S f): what the target gradients v ask for beyond the gradients of f. The target is given by its excess over the
// gradient of f, integrated along the edges: excess(f, i, j) from corner i to corner j of triangle f, by channel.
template <class Excess>
void gradient_residual(const Indexed_triangles& mesh, const Triangle_metrics& metrics, const Weights& weights,
                       const Degrees_of_freedom& unknowns, const Excess& excess, bool parallel, Eigen::MatrixXd& residual)
{
  const auto sum_at = [&](int v, const Block_coefficients& coefficients, auto& sum) {
    for(const int* c = mesh.corners.begin(v); c != mesh.corners.end(v); ++c)
    {
      const int f = *c / 3, i = *c % 3, j = (i + 1) % 3, k = (i + 2) % 3;
      const double beta = weights.gradient_at(f);
      const Triangle_coefficients of_f = coefficients(f);
      const double to_a = beta * of_f.conductances[k], to_b = beta * of_f.conductances[j];
      const auto along_a = excess(f, i, j), along_b = excess(f, i, k);
      for(Eigen::Index channel = 0; channel < sum.size(); ++channel)
        sum[channel] -= to_a * along_a[channel] + to_b * along_b[channel];
    }
  };
  for_each_degree_of_freedom(parallel, unknowns, mesh, metrics, [&](int v, int row, const Block_coefficients& coefficients) {
    if(residual.cols() == 3) // the compiler unrolls what it knows the length of
    {
      Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
      sum_at(v, coefficients, sum);
      residual.row(row) = sum;
    }
    else
    {
      auto sum = residual.row(row);
      sum.setZero();
      sum_at(v, coefficients, sum);
    }
  });
}

// Takes from the residual what the displacements of vertices that are not solved for bring about.
inline void move_to_right_hand_side(const Indexed_triangles& mesh, const Triangle_metrics& metrics,
                                    const Weights& weights, const Degrees_of_freedom& unknowns, const Signal& displacement,
                                    bool parallel, Eigen::MatrixXd& residual)
{
  for_each_degree_of_freedom(parallel, unknowns, mesh, metrics, [&](int v, int row, const Block_coefficients& coefficients) {
    for(const int* c = mesh.corners.begin(v); c != mesh.corners.end(v); ++c)
    {
      const Row_entries entries = row_entries(mesh, coefficients(*c / 3), weights, *c);
      const auto others = mesh.opposite_vertices(*c);
      if(unknowns.of_vertex[others[0]] < 0)
        residual.row(row) -= entries.va * displacement.row(others[0]);
      if(unknowns.of_vertex[others[1]] < 0)
        residual.row(row) -= entries.vb * displacement.row(others[1]);
    }
  });
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_ASSEMBLY_H
