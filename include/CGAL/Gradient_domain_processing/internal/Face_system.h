// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FACE_SYSTEM_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FACE_SYSTEM_H

#include <CGAL/Gradient_domain_processing/internal/Gradient_domain_system.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// An edge between two triangles, from vertex `from` to vertex `to` in the first of them.
struct Interior_edge
{
  int first, second; // triangles
  int from, to;      // vertices
};

inline std::vector<Interior_edge> interior_edges(const Mesh_arrays& mesh)
{
  std::vector<Interior_edge> edges;
  edges.reserve(mesh.triangles.size() * 3 / 2);
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    for(const int* c = mesh.corners.begin(v); c != mesh.corners.end(v); ++c)
    {
      const int w = mesh.opposite_vertices(*c)[0];
      if(w < v)
        continue;
      for(const int* d = mesh.corners.begin(v); d != mesh.corners.end(v); ++d)
        if(mesh.opposite_vertices(*d)[1] == w && *d / 3 != *c / 3)
          edges.push_back({*c / 3, *d / 3, v, w});
    }
  return edges;
}

// The system (A + L) g = A f for signals that are constant on faces: A holds a mass for every face and L is the graph
// Laplacian of the dual mesh with a weight for every interior edge. Pattern and analysis serve all weights.
template <class SparseLinearSolver>
class Face_system
{
  std::vector<Interior_edge> m_edges;
  Unknowns m_unknowns;
  Sparse_matrix m_matrix;
  Linear_solver<SparseLinearSolver> m_solver;
  bool m_parallel = true;

public:
  explicit Face_system(const SparseLinearSolver& solver) : m_solver(solver) {}

  const std::vector<Interior_edge>& edges() const { return m_edges; }

  Error_code analyze(const Mesh_arrays& mesh, bool parallel, Progress& progress)
  {
    if(!progress.go_on(0))
      return ERROR_CANCELLED;
    Stage_scope stage(progress, Stage::ANALYZE);
    m_parallel = parallel;
    m_edges = interior_edges(mesh);

    const int n = mesh.number_of_triangles();
    const Lists neighbors = dual_neighbors(n);
    std::vector<Vec3> centers(n);
    for(int f = 0; f < n; ++f)
    {
      const auto& t = mesh.triangles[f];
      centers[f] = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3;
    }
    m_unknowns = order_unknowns(centers, neighbors, [](int) { return true; }, parallel);
    m_matrix = matrix_of(sparsity_pattern(neighbors, m_unknowns, m_solver.reads_lower_triangle, parallel));
    return m_solver.analyze(m_matrix);
  }

  // Masses are positive, weights at least zero.
  Error_code factorize(const std::vector<double>& masses, const std::vector<double>& weights, Progress& progress)
  {
    if(!progress.go_on(0))
      return ERROR_CANCELLED;
    {
      Stage_scope stage(progress, Stage::ASSEMBLE);
      std::fill(m_matrix.valuePtr(), m_matrix.valuePtr() + m_matrix.nonZeros(), 0.);
      for(std::size_t f = 0; f < masses.size(); ++f)
        add(m_unknowns.column[f], m_unknowns.column[f], masses[f]);
      for(std::size_t e = 0; e < m_edges.size(); ++e)
      {
        const int i = m_unknowns.column[m_edges[e].first], j = m_unknowns.column[m_edges[e].second];
        add(i, i, weights[e]);
        add(j, j, weights[e]);
        add((std::max)(i, j), (std::min)(i, j), -weights[e]);
        if(!m_solver.reads_lower_triangle)
          add((std::min)(i, j), (std::max)(i, j), -weights[e]);
      }
    }
    Stage_scope stage(progress, Stage::FACTOR);
    return m_solver.factorize(m_matrix);
  }

  // `right` and `solution` have a row a face.
  Error_code solve(const Signal& right, Signal& solution, Progress& progress)
  {
    if(!progress.go_on(0))
      return ERROR_CANCELLED;
    Stage_scope stage(progress, Stage::SOLVE);
    Eigen::MatrixXd b(right.rows(), right.cols()), x;
    for(Eigen::Index k = 0; k < b.rows(); ++k)
      b.row(k) = right.row(m_unknowns.vertex[k]);
    if(const Error_code code = m_solver.solve(b, x))
      return code;
    solution.resize(x.rows(), x.cols());
    for(Eigen::Index k = 0; k < x.rows(); ++k)
      solution.row(m_unknowns.vertex[k]) = x.row(k);
    return solution.allFinite() ? OK : ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  }

private:
  Lists dual_neighbors(int n) const
  {
    std::vector<std::array<int, 3> > found(n);
    std::vector<char> count(n, 0);
    const auto insert = [&](int f, int g) {
      const auto last = found[f].begin() + count[f];
      if(std::find(found[f].begin(), last, g) == last)
        found[f][count[f]++] = g;
    };
    for(const Interior_edge& e : m_edges)
    {
      insert(e.first, e.second);
      insert(e.second, e.first);
    }
    Lists lists;
    lists.offsets.push_back(0);
    for(int f = 0; f < n; ++f)
    {
      lists.items.insert(lists.items.end(), found[f].begin(), found[f].begin() + count[f]);
      lists.offsets.push_back(int(lists.items.size()));
    }
    return lists;
  }

  void add(int row, int column, double value)
  {
    const int* rows = m_matrix.innerIndexPtr();
    for(int at = m_matrix.outerIndexPtr()[column]; at < m_matrix.outerIndexPtr()[column + 1]; ++at)
      if(rows[at] == row)
        m_matrix.valuePtr()[at] += value;
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FACE_SYSTEM_H
