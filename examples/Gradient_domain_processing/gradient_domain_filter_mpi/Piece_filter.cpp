// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Piece_filter.h"

#include <CGAL/Gradient_domain_processing/internal/curvature/estimates.h>
#include <CGAL/Gradient_domain_processing/internal/energy/assemble.h>
#include <CGAL/Gradient_domain_processing/internal/energy/right_hand_side.h>
#include <CGAL/Gradient_domain_processing/internal/energy/sparsity_pattern.h>
#include <CGAL/Gradient_domain_processing/internal/energy/target_field/Scaled_gradient.h>
#include <CGAL/Gradient_domain_processing/internal/metric/curvature_metric.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

namespace {

namespace GDP = CGAL::Gradient_domain_processing;
using namespace GDP::internal;

constexpr bool in_parallel = false; // the ranks are

void update(const Halo& halo, Signal& signal)
{
  std::vector<double> column(std::size_t(signal.rows()));
  for(Eigen::Index channel = 0; channel < signal.cols(); ++channel)
  {
    for(std::size_t i = 0; i < column.size(); ++i)
      column[i] = signal(Eigen::Index(i), channel);
    halo.update(column);
    for(std::size_t i = 0; i < column.size(); ++i)
      signal(Eigen::Index(i), channel) = column[i];
  }
}

} // namespace

// One matrix, and what it was made of.
class Piece_filter::System
{
  Piece_filter& m_filter;
  const Triangle_metrics& m_metrics;
  const Energy_weights& m_weights;
  std::unique_ptr<Petsc_system> m_petsc;

public:
  System(Piece_filter& filter, const Triangle_metrics& metrics, const Energy_weights& weights)
    : m_filter(filter), m_metrics(metrics), m_weights(weights)
  {
    Sparse_matrix matrix;
    filter.m_ranks.together([&] {
      const Indexed_triangles& mesh = filter.m_piece.mesh;
      const Lists pattern = sparsity_pattern(mesh.one_rings(in_parallel), filter.m_dofs, false, in_parallel);
      set_pattern(pattern, in_parallel, matrix);
      assemble(mesh, metrics, weights, filter.m_dofs, in_parallel, matrix);
    });
    m_petsc = std::make_unique<Petsc_system>(filter.m_ranks, matrix, filter.m_own_dofs.size(), filter.m_global_number);
    filter.preconditioner = m_petsc->preconditioner();
    ++filter.systems;
  }

  // The change of all local vertices.
  template <class Target_field>
  Signal solve(const Target_field& target)
  {
    const Indexed_triangles& mesh = m_filter.m_piece.mesh;
    Eigen::MatrixXd values;
    m_filter.m_ranks.together([&] {
      values = target_residual(mesh, m_metrics, m_weights, m_filter.m_own_dofs, target, in_parallel);
    });
    const int before = m_petsc->iterations();
    m_petsc->solve(values);
    m_filter.iterations += m_petsc->iterations() - before;
    Signal change = Signal::Zero(mesh.number_of_vertices(), values.cols());
    for(int dof = 0; dof < m_filter.m_own_dofs.size(); ++dof)
      change.row(m_filter.m_own_dofs.vertex[std::size_t(dof)]) = values.row(dof);
    m_filter.m_ranks.agree(change.allFinite() ? "" : "the system cannot be solved");
    update(m_filter.m_piece.vertices, change);
    return change;
  }
};

Piece_filter::Piece_filter(const Ranks& ranks, const Options& options, Mesh_piece& piece, const Given& given)
  : m_ranks(ranks), m_options(options), m_piece(piece), m_given(given)
{
  const Indexed_triangles& mesh = piece.mesh;
  double area = 0;
  for(int f = 0; f < mesh.number_of_triangles(); ++f)
    if(piece.is_counted[std::size_t(f)])
      area += mesh.embedding_metric(f).with_area_bounded_below(degeneracy_ratio).area();
  m_squared_length_unit = options.area_normalization ? ranks.sum(area) : 1 / (piece.unit() * piece.unit());
  set_constrained();
  set_weights();
  set_metrics();
}

void Piece_filter::set_constrained()
{
  const Indexed_triangles& mesh = m_piece.mesh;
  m_is_constrained.assign(mesh.points.size(), 0);
  for(int row = 0; row < m_piece.rows.owned() && !m_given.is_constrained.empty(); ++row)
    if(const int v = m_piece.vertex_of_row[std::size_t(row)]; v >= 0 && m_given.is_constrained[std::size_t(row)] != 0)
      m_is_constrained[std::size_t(v)] = 1;
  m_piece.vertices.update(m_is_constrained);

  // owned vertices come first, and so do their degrees of freedom
  std::vector<char> is_free(mesh.points.size());
  for(std::size_t v = 0; v < is_free.size(); ++v)
    is_free[v] = !m_is_constrained[v];
  m_dofs = numbered_in_memory_order(is_free);
  std::fill(is_free.begin() + m_piece.vertices.owned(), is_free.end(), char(0));
  m_own_dofs = numbered_in_memory_order(is_free);
  const Global first = m_ranks.first_of_ranks(m_own_dofs.size())[std::size_t(m_ranks.rank())];
  std::vector<Global> number(mesh.points.size(), -1);
  for(int dof = 0; dof < m_own_dofs.size(); ++dof)
    number[std::size_t(m_own_dofs.vertex[std::size_t(dof)])] = first + dof;
  m_piece.vertices.update(number);
  for(int v : m_dofs.vertex)
    m_global_number.push_back(number[std::size_t(v)]);
}

std::vector<double> Piece_filter::at_vertices(const std::vector<double>& by_row) const
{
  std::vector<double> sums, counts;
  if(by_row.empty())
    return sums;
  sums.assign(m_piece.mesh.points.size(), 0.);
  counts.assign(m_piece.mesh.points.size(), 0.);
  for(int row = 0; row < m_piece.rows.owned(); ++row)
    if(const int v = m_piece.vertex_of_row[std::size_t(row)]; v >= 0)
    {
      sums[std::size_t(v)] += by_row[std::size_t(row)];
      ++counts[std::size_t(v)];
    }
  for(int v = 0; v < m_piece.vertices.owned(); ++v)
    sums[std::size_t(v)] /= counts[std::size_t(v)];
  m_piece.vertices.update(sums);
  return sums;
}

std::vector<double> Piece_filter::at_triangles(const std::vector<double>& by_row, double elsewhere) const
{
  std::vector<double> numbers;
  for(std::size_t f = 0; f < m_piece.mesh.triangles.size() && !by_row.empty(); ++f)
  {
    const std::array<int, 3>& rows = m_piece.mesh.rows[f];
    numbers.push_back(!m_piece.is_near[f] ? elsewhere
                                          : (by_row[std::size_t(rows[0])] + by_row[std::size_t(rows[1])]
                                             + by_row[std::size_t(rows[2])]) / 3);
  }
  return numbers;
}

void Piece_filter::set_weights()
{
  m_weights.value = m_options.value_weight;
  m_weights.gradient = m_options.gradient_weight * m_squared_length_unit;
  m_weights.scale = m_options.gradient_scale;
  m_weights.value_at_vertex = at_vertices(m_given.value_weights);
  m_weights.gradient_at_triangle = at_triangles(m_given.gradient_weights, 0);
  for(double& weight : m_weights.gradient_at_triangle)
    weight *= m_squared_length_unit;
  m_weights.scale_at_triangle = at_triangles(m_given.gradient_scales, 0);
}

void Piece_filter::set_metrics()
{
  m_metrics.given.clear();
  if(!m_options.has_metric() || m_options.curvature_weight == 0)
    return;
  const std::vector<Principal_curvatures> curvatures =
    m_options.curvature == GDP::Curvature_estimator::JETS ? curvatures_by_jets() : curvatures_by_normals();
  m_ranks.together([&] {
    const Curvature_stretch stretch{m_options.metric, m_options.curvature_weight * m_squared_length_unit};
    if(stretched_metrics(m_piece.mesh, curvatures, stretch, in_parallel, m_metrics.given) >= 0)
      throw Failure("the metric of a face is not positive definite");
  });
}

// Weight gamma, in the embedding metric.
void Piece_filter::presmooth(Signal& by_vertex)
{
  if(m_options.presmoothing_weight == 0)
    return;
  Energy_weights weights;
  weights.gradient = m_options.presmoothing_weight * m_squared_length_unit;
  const Triangle_metrics metrics;
  System system(*this, metrics, weights);
  const Signal rows = by_row(by_vertex);
  by_vertex += system.solve(Scaled_gradient(m_piece.mesh, weights, rows));
}

std::vector<Vec3> Piece_filter::own_normals(const std::vector<Vec3>& points) const
{
  std::vector<Vec3> normals(points.size(), Vec3::Zero());
  if(m_given.normals.rows() == 0)
    normals = m_piece.mesh.vertex_normals(points, in_parallel); // those of ghosts are not complete
  else
  {
    std::vector<int> counts(points.size(), 0);
    for(int row = 0; row < m_piece.rows.owned(); ++row)
      if(const int v = m_piece.vertex_of_row[std::size_t(row)]; v >= 0)
      {
        normals[std::size_t(v)] += m_given.normals.row(row).transpose();
        ++counts[std::size_t(v)];
      }
    for(int v = 0; v < m_piece.vertices.owned(); ++v)
      normals[std::size_t(v)] /= counts[std::size_t(v)];
  }
  m_piece.vertices.update(normals);
  return normals;
}

std::vector<Principal_curvatures> Piece_filter::curvatures_by_jets()
{
  Signal positions = as_signal(m_piece.mesh.points);
  presmooth(positions);
  const std::vector<Vec3> points = as_vectors(positions), normals = own_normals(points);
  std::vector<Principal_curvatures> at_vertices;
  m_ranks.together([&] {
    vertex_curvatures_by_jets(m_piece.mesh, points, normals, m_options.jet_degree, in_parallel,
                              [](double) { return true; }, at_vertices);
  });
  typedef std::array<double, 8> Numbers;
  m_piece.vertices.update<Numbers>(
    [&](int v) {
      const Principal_curvatures& k = at_vertices[std::size_t(v)];
      return Numbers{{k.min_curvature, k.max_curvature, k.min_direction[0], k.min_direction[1], k.min_direction[2],
                      k.max_direction[0], k.max_direction[1], k.max_direction[2]}};
    },
    [&](int v, const Numbers& x) {
      at_vertices[std::size_t(v)] = {x[0], x[1], Vec3(x[2], x[3], x[4]), Vec3(x[5], x[6], x[7])};
    });
  return triangle_curvatures(m_piece.mesh, in_parallel, at_vertices);
}

std::vector<Principal_curvatures> Piece_filter::curvatures_by_normals()
{
  Signal normals = as_signal(own_normals(m_piece.mesh.points));
  presmooth(normals);
  return triangle_curvatures_by_normals(m_piece.mesh, in_parallel, as_vectors(normals));
}

Signal Piece_filter::by_row(const Signal& by_vertex) const
{
  Signal rows(m_piece.rows.size(), by_vertex.cols());
  for(int row = 0; row < m_piece.rows.size(); ++row)
    if(by_vertex.rows() > 0)
      rows.row(row) = by_vertex.row(m_piece.mesh.vertex_of(row));
  return rows;
}

void Piece_filter::move_points(const Signal& change)
{
  for(std::size_t v = 0; v < m_piece.mesh.points.size(); ++v)
    m_piece.mesh.points[v] += change.row(Eigen::Index(v)).transpose();
}

void Piece_filter::smooth(System& system)
{
  move_points(system.solve(Scaled_gradient_of_positions(m_piece.mesh, m_weights)));
}

// What is missing after a pass is filtered again, so that low frequencies stay.
void Piece_filter::smooth_without_shrinking(System& system)
{
  Signal missing = as_signal(m_piece.mesh.points);
  for(int i = 0; i < m_options.non_shrinking; ++i)
  {
    const Signal rows = by_row(missing);
    missing = -system.solve(Scaled_gradient(m_piece.mesh, m_weights, rows));
  }
  move_points(-missing);
}

void Piece_filter::enhance_details()
{
  {
    System system(*this, m_metrics, m_weights);
    smooth(system);
  }
  m_metrics.given.clear();
  m_weights.set_gradient(m_options.sharpening_weight * m_squared_length_unit);
  m_weights.set_scale(m_options.sharpening_scale);
  System system(*this, m_metrics, m_weights);
  smooth(system);
}

void Piece_filter::filter_positions()
{
  if(m_options.operation == Operation::ENHANCE_DETAILS)
    return enhance_details();
  for(int i = 0; i < m_options.iterations; ++i)
  {
    if(i > 0)
      set_metrics();
    System system(*this, m_metrics, m_weights);
    if(m_options.non_shrinking == 1)
      smooth(system);
    else
      smooth_without_shrinking(system);
  }
}

void Piece_filter::filter_signal(Signal& signal)
{
  System system(*this, m_metrics, m_weights);
  for(int i = 0; i < m_options.iterations; ++i)
  {
    signal += by_row(system.solve(Scaled_gradient(m_piece.mesh, m_weights, signal)));
    update(m_piece.rows, signal); // rows of ghosts without a near triangle have no vertex here
  }
}
