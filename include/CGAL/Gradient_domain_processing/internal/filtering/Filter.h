// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_H

#include <CGAL/Gradient_domain_processing/enum.h>
#include <CGAL/Gradient_domain_processing/internal/curvature/estimates.h>
#include <CGAL/Gradient_domain_processing/internal/energy/Linear_system.h>
#include <CGAL/Gradient_domain_processing/internal/energy/border_energy.h>
#include <CGAL/Gradient_domain_processing/internal/energy/target_field/Scaled_gradient.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Surface_elements.h>
#include <CGAL/Gradient_domain_processing/internal/metric/curvature_metric.h>

#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

inline bool is_weight(double w) { return w >= 0 && std::isfinite(w); }

struct Curvature_options
{
  Curvature_estimator estimator = Curvature_estimator::JETS;
  int jet_degree = 2;
  double presmoothing_weight = 0; // in units of the arrays
  std::vector<Vec3> normals;      // at the vertices; none: those of the mesh
};

// The energy of a surface on arrays, with its weights, metric and border condition: what all verbs share.
template <class SparseLinearSolver>
class Filter
{
public:
  Linear_system<SparseLinearSolver> system;
  double squared_length_unit = 1; // weights times it are in units of the arrays
  Border_condition border_condition = Border_condition::FREE;
  Border_condition line_condition = Border_condition::FREE; // where three triangles or more share an edge
  std::vector<char> is_constrained; // by the caller or for a face outside of the region, not by a condition
  std::vector<char> is_held;        // these, and those of a border or a line that is fixed
  Culprit culprit;                  // of the last error

private:
  Progress* m_progress; // of the solver that owns this

public:
  Filter(const SparseLinearSolver& solver, Progress& progress) : system(solver), m_progress(&progress) {}

  const Indexed_triangles& mesh() const { return system.mesh; }
  Progress& progress() { return *m_progress; }

  // At the beginning of every stage the visitor is asked.
  Error_code ready() { return m_progress->go_on() ? ok : error_cancelled; }

  void constrain(std::vector<char> constrained)
  {
    is_constrained = is_held = constrained;
    if(border_condition != Border_condition::FREE)
      hold(border_condition, mesh().is_on_border, constrained);
    if(line_condition != Border_condition::FREE)
      hold(line_condition, vertices_at(line_edges(mesh()), mesh()), constrained);
    system.set_constrained(std::move(constrained));
  }

  bool has_constraints() const
  {
    return std::find(is_constrained.begin(), is_constrained.end(), 1) != is_constrained.end();
  }

  bool is_moved(int v) const { return mesh().corners.size(v) > 0 && !is_held[v]; }

  // The volume has a meaning where all of a closed mesh moves freely.
  bool encloses_volume() const
  {
    for(int v = 0; v < mesh().number_of_vertices(); ++v)
      if(mesh().is_on_border[v])
        return false;
    return !has_constraints();
  }

  // Every stretch in units of the arrays.
  Error_code set_curvature_metric(const std::vector<Principal_curvatures>& curvatures, const Stretch& stretch)
  {
    if(const Error_code code = ready())
      return code;
    Stage_scope stage(*m_progress, Stage::METRIC);
    Untouched_vector<Triangle_metric> metrics;
    const int bad = stretched_metrics(mesh(), curvatures, stretch, system.parallel, metrics);
    if(bad >= 0)
    {
      culprit.face = mesh().face_of(bad);
      return error_invalid_metric;
    }
    system.set_metrics(std::move(metrics));
    return ok;
  }

  // At the vertices, by jets fitted to presmoothed positions.
  Error_code estimate_by_jets(const Curvature_options& options, std::vector<Principal_curvatures>& curvatures)
  {
    Signal positions = as_signal(mesh().points);
    if(const Error_code code = presmooth(options.presmoothing_weight, positions))
      return code;
    if(const Error_code code = ready())
      return code;
    Stage_scope stage(*m_progress, Stage::CURVATURE);
    const std::vector<Vec3> points = as_vectors(positions);
    const bool is_done = vertex_curvatures_by_jets<>(
      mesh(), points, options.normals.empty() ? mesh().vertex_normals(points, system.parallel) : options.normals, options.jet_degree,
      system.parallel, [this](double part) { return this->m_progress->go_on(part); }, curvatures);
    return is_done ? ok : error_cancelled;
  }

  // At the triangles.
  Error_code estimate(const Curvature_options& options, std::vector<Principal_curvatures>& curvatures)
  {
    if(options.estimator == Curvature_estimator::JETS)
    {
      std::vector<Principal_curvatures> at_vertices;
      if(const Error_code code = estimate_by_jets(options, at_vertices))
        return code;
      curvatures = triangle_curvatures(mesh(), system.parallel, at_vertices);
      return ok;
    }
    Signal normals = as_signal(options.normals.empty() ? mesh().vertex_normals(system.parallel) : options.normals);
    if(const Error_code code = presmooth(options.presmoothing_weight, normals))
      return code;
    if(const Error_code code = ready())
      return code;
    Stage_scope stage(*m_progress, Stage::CURVATURE);
    curvatures = triangle_curvatures_by_normals(mesh(), system.parallel, as_vectors(normals));
    return ok;
  }

  // The change of every vertex.
  template <class Target_field>
  Error_code solve(const Target_field& target, Signal& change)
  {
    std::vector<Border_edge> edges;
    if(border_condition == Border_condition::ALONG_BORDER)
      edges = border_edges(mesh());
    if(line_condition == Border_condition::ALONG_BORDER)
      for(const Border_edge& e : line_edges(mesh()))
        edges.push_back(e);
    if(edges.empty())
      return system.solve(target, *m_progress, change);
    change.setZero(mesh().number_of_vertices(), target.channels());
    if(const Error_code code = displace_curves(mesh(), std::move(edges), system.weights(), is_held, target, change))
      return code;
    return system.solve(target, *m_progress, change, true);
  }

  // Adds a change to the rows of all vertices: those of a seam go on differing as they did.
  void add(const Signal& change, Signal& signal) const
  {
    if(mesh().vertex_of_row.empty())
      signal += change;
    else
      for(int row = 0; row < mesh().number_of_rows(); ++row)
        signal.row(row) += change.row(mesh().vertex_of(row));
  }

  Error_code filter(Signal& signal)
  {
    Signal change;
    if(const Error_code code = solve(Scaled_gradient(mesh(), system.weights(), signal), change))
      return code;
    add(change, signal);
    return ok;
  }

  // One pass over the positions in the arrays.
  Error_code filter_points()
  {
    Signal change;
    if(const Error_code code = solve(Scaled_gradient_of_positions(mesh(), system.weights()), change))
      return code;
    move_points(change);
    return ok;
  }

  // The change by vertex of a signal by vertex.
  Error_code solve_by_vertex(const Signal& signal, Signal& change)
  {
    return solve(Scaled_difference_of_vertices{mesh(), system.weights(), signal}, change);
  }

  void move_points(const Signal& change)
  {
    std::vector<Vec3>& points = system.mesh.points;
    for(std::size_t v = 0; v < points.size(); ++v)
      points[v] += change.row(Eigen::Index(v)).transpose();
  }

private:
  // Vertices under a condition are constrained on the surface; unless they are fixed they move with their curve.
  void hold(Border_condition condition, const std::vector<char>& is_on_curve, std::vector<char>& constrained)
  {
    for(std::size_t v = 0; v < constrained.size(); ++v)
      if(is_on_curve[v])
      {
        constrained[v] = 1;
        is_held[v] = is_held[v] || condition == Border_condition::FIXED;
      }
  }

  // A copy for estimating curvatures: smoothed with the metric of the embedding, by vertex. The system's own metric and weights come
  // back, whatever happens.
  Error_code presmooth(double weight, Signal& signal)
  {
    if(weight == 0)
      return ok;
    struct Other_coefficients
    {
      typedef typename Linear_system<SparseLinearSolver>::Coefficients Coefficients;
      Linear_system<SparseLinearSolver>& system;
      Coefficients own;
      Other_coefficients(Linear_system<SparseLinearSolver>& s, Coefficients other) : system(s), own(s.exchange_coefficients(std::move(other))) {}
      ~Other_coefficients() { system.exchange_coefficients(std::move(own)); }
    };
    typename Other_coefficients::Coefficients other;
    other.weights.gradient = weight;
    const Other_coefficients scope(system, std::move(other));
    Signal change;
    if(const Error_code code = system.solve(Scaled_difference_of_vertices{mesh(), system.weights(), signal}, *m_progress, change))
      return code;
    signal += change;
    return ok;
  }

  // v = lambda grad f for a signal by vertex.
  struct Scaled_difference_of_vertices
  {
    const Indexed_triangles& mesh;
    const Energy_weights& weights;
    const Signal& signal;

    int channels() const { return int(signal.cols()); }

    template <class Channels>
    void residual(int f, int i, int j, Channels& along) const
    {
      const auto& t = mesh.triangles[f];
      for(int channel = 0; channel < along.size(); ++channel)
        along[channel] = (weights.scale_at(f) - 1) * (signal(t[j], channel) - signal(t[i], channel));
    }
  };
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_H
