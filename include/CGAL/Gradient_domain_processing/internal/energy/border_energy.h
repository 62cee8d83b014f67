// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_BORDER_ENERGY_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_BORDER_ENERGY_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/internal/energy/assembly.h>
#include <CGAL/Gradient_domain_processing/internal/energy/Linear_system.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// An edge with one triangle, from corner to the next corner of it.
struct Border_edge
{
  int triangle, from, to; // corners
  double length;
};

inline std::vector<Border_edge> border_edges(const Indexed_triangles& mesh)
{
  std::vector<Border_edge> edges;
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    for(const int* c = mesh.corners.begin(v); c != mesh.corners.end(v); ++c)
    {
      const int a = mesh.opposite_vertices(*c)[0];
      const bool has_opposite = std::any_of(mesh.corners.begin(v), mesh.corners.end(v),
                                            [&](int other) { return mesh.opposite_vertices(other)[1] == a; });
      if(!has_opposite)
        edges.push_back({*c / 3, *c % 3, (*c % 3 + 1) % 3, (mesh.points[v] - mesh.points[a]).norm()});
    }
  double longest = 0;
  for(const Border_edge& e : edges)
    longest = (std::max)(longest, e.length);
  for(Border_edge& e : edges)
    e.length = (std::max)(e.length, degeneracy_ratio * longest);
  return edges;
}

// Whether a piece of border that is stiff has neither a held vertex nor a value weight to hold it.
inline bool has_floating_border(const Indexed_triangles& mesh, const Weights& weights, const std::vector<Border_edge>& edges,
                                const std::vector<int>& column, int n)
{
  std::vector<int> parent(n);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int i) {
    while(parent[i] != i)
      i = parent[i] = parent[parent[i]];
    return i;
  };
  const auto for_each_edge = [&](const auto& work) {
    for(const Border_edge& e : edges)
    {
      const auto& t = mesh.triangles[e.triangle];
      work(t[e.from], t[e.to], weights.gradient_at(e.triangle) > 0);
    }
  };
  for_each_edge([&](int v, int w, bool is_stiff) {
    if(is_stiff && column[v] >= 0 && column[w] >= 0)
      parent[root(column[v])] = root(column[w]);
  });
  std::vector<char> is_held(n, 0), floats(n, 0);
  for_each_edge([&](int v, int w, bool is_stiff) {
    const bool has_value = weights.value_at(v) > 0 || weights.value_at(w) > 0;
    for(int i : {column[v], column[w]})
      if(i >= 0)
      {
        is_held[root(i)] |= has_value || (is_stiff && (column[v] < 0 || column[w] < 0));
        floats[root(i)] |= is_stiff;
      }
  });
  for(int i = 0; i < n; ++i)
    if(floats[i] && !is_held[i])
      return true;
  return false;
}

// Solves the one-dimensional problem on the border curves: the energy with lengths in place of areas and the derivative along
// the border in place of the gradient. Only border vertices that are not `held` move.
template <class Excess>
Error_code displace_border(const Indexed_triangles& mesh, const Weights& weights, const std::vector<char>& is_held,
                           const Excess& excess, int channels, Signal& displacement)
{
  std::vector<int> column(mesh.number_of_vertices(), -1), vertex;
  const std::vector<Border_edge> edges = border_edges(mesh);
  for(const Border_edge& e : edges)
    for(int corner : {e.from, e.to})
    {
      const int v = mesh.triangles[e.triangle][corner];
      if(!is_held[v] && column[v] < 0)
      {
        column[v] = int(vertex.size());
        vertex.push_back(v);
      }
    }
  if(vertex.empty())
    return OK;

  const int n = int(vertex.size());
  if(has_floating_border(mesh, weights, edges, column, n))
    return ERROR_UNCONSTRAINED;
  std::vector<Eigen::Triplet<double> > entries; // a border is short
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, channels);
  for(const Border_edge& e : edges)
  {
    const auto& t = mesh.triangles[e.triangle];
    const int ends[2] = {t[e.from], t[e.to]}, corner[2] = {e.from, e.to};
    const double stiffness = weights.gradient_at(e.triangle) / e.length;
    for(int i = 0; i < 2; ++i)
    {
      const int row = column[ends[i]], other = column[ends[1 - i]];
      if(row < 0)
        continue;
      const double here = weights.value_at(ends[i]), there = weights.value_at(ends[1 - i]);
      entries.emplace_back(row, row, e.length * (here / 4 + there / 12) + stiffness);
      if(other >= 0)
        entries.emplace_back(row, other, e.length * (here + there) / 12 - stiffness);
      const auto along = excess(e.triangle, corner[i], corner[1 - i]);
      for(int channel = 0; channel < channels; ++channel)
        right(row, channel) -= stiffness * along[channel];
    }
  }
  Sparse_matrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  for(int i = 0; i < n; ++i)
    if(matrix.coeff(i, i) == 0)
      matrix.coeffRef(i, i) = 1;
  Eigen::SimplicialLLT<Sparse_matrix> solver(matrix);
  if(solver.info() != Eigen::Success)
    return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  const Eigen::MatrixXd solution = solver.solve(right);
  for(int i = 0; i < n; ++i)
    displacement.row(vertex[i]) = solution.row(i);
  return OK;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_BORDER_ENERGY_H
