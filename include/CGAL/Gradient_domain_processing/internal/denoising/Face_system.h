// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_FACE_SYSTEM_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_FACE_SYSTEM_H

#include <CGAL/Gradient_domain_processing/internal/energy/Linear_system.h>

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

  int other(int triangle) const { return first + second - triangle; }
};

inline std::vector<Interior_edge> interior_edges(const Indexed_triangles& mesh)
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
  Lists m_edges_of_face;
  Degrees_of_freedom m_unknowns;
  Sparse_matrix m_matrix;
  Linear_solver<SparseLinearSolver> m_solver;
  bool m_parallel = true;

public:
  explicit Face_system(const SparseLinearSolver& solver) : m_solver(solver) {}

  const std::vector<Interior_edge>& edges() const { return m_edges; }

  Error_code analyze(const Indexed_triangles& mesh, bool parallel, Progress& progress)
  {
    if(!progress.go_on(0))
      return ERROR_CANCELLED;
    Stage_scope stage(progress, Stage::ANALYZE);
    m_parallel = parallel;
    m_edges = interior_edges(mesh);

    const int n = mesh.number_of_triangles();
    m_edges_of_face = items_by_key(n, [&](const auto& visit) {
      for(std::size_t e = 0; e < m_edges.size(); ++e)
        for(int f : {m_edges[e].first, m_edges[e].second})
          visit(f, int(e));
    });
    const Lists neighbors = dual_neighbors();
    std::vector<Vec3> centers(n);
    parallel_for(parallel, n, [&](std::size_t f) {
      const auto& t = mesh.triangles[f];
      centers[f] = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3;
    });
    m_unknowns = elimination_order(centers, neighbors, std::vector<char>(n, 1), parallel);
    set_pattern(sparsity_pattern(neighbors, m_unknowns, m_solver.reads_lower_triangle, parallel), parallel, m_matrix);
    m_solver.merge_small_fronts();
    return m_solver.analyze(m_matrix);
  }

  // Masses are positive, weights at least zero.
  Error_code factorize(const std::vector<double>& masses, const std::vector<double>& weights, Progress& progress)
  {
    if(!progress.go_on(0))
      return ERROR_CANCELLED;
    {
      Stage_scope stage(progress, Stage::ASSEMBLE);
      assemble(masses, weights);
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
    Eigen::MatrixXd values(right.rows(), right.cols());
    for_each_degree_of_freedom(m_parallel, m_unknowns, [&](int f, int row) { values.row(row) = right.row(f); });
    if(const Error_code code = m_solver.solve(values, values))
      return code;
    solution.resize(values.rows(), values.cols());
    for_each_degree_of_freedom(m_parallel, m_unknowns, [&](int f, int row) { solution.row(f) = values.row(row); });
    return solution.allFinite() ? OK : ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  }

private:
  // Each once, however many edges two triangles share.
  Lists dual_neighbors() const
  {
    Lists neighbors;
    neighbors.offsets.push_back(0);
    for(int f = 0; f < m_edges_of_face.size(); ++f)
    {
      for(const int* e = m_edges_of_face.begin(f); e != m_edges_of_face.end(f); ++e)
      {
        const int g = m_edges[*e].other(f);
        if(std::find(neighbors.items.begin() + neighbors.offsets[f], neighbors.items.end(), g) == neighbors.items.end())
          neighbors.items.push_back(g);
      }
      neighbors.offsets.push_back(int(neighbors.items.size()));
    }
    return neighbors;
  }

  void assemble(const std::vector<double>& masses, const std::vector<double>& weights)
  {
    const int* const offsets = m_matrix.outerIndexPtr();
    const int* const rows = m_matrix.innerIndexPtr();
    double* const values = m_matrix.valuePtr();
    for_each_degree_of_freedom(m_parallel, m_unknowns, [&](int f, int column) {
      const int first = offsets[column], last = offsets[column + 1];
      std::fill(values + first, values + last, 0.);
      const auto add = [&](int row, double value) {
        const int* const at = std::find(rows + first, rows + last, row);
        if(at != rows + last) // the rest is in the upper triangle
          values[at - rows] += value;
      };
      add(column, masses[f]);
      for(const int* e = m_edges_of_face.begin(f); e != m_edges_of_face.end(f); ++e)
      {
        add(column, weights[*e]);
        add(m_unknowns.of_vertex[m_edges[*e].other(f)], -weights[*e]);
      }
    });
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_FACE_SYSTEM_H
