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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_H

#include <CGAL/Gradient_domain_processing/Hessian_kind.h>
#include <CGAL/Gradient_domain_processing/enum.h>
#include <CGAL/Gradient_domain_processing/internal/energy/Linear_system.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Surface_elements.h>
#include <CGAL/Gradient_domain_processing/internal/metric/curvature_metric.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
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
class Filter
{
public:
  Linear_system system;
  double squared_length_unit = 1; // weights times it are in units of the arrays
  Border_condition border_condition = Border_condition::FREE;
  Border_condition line_condition = Border_condition::FREE; // where three triangles or more share an edge
  std::vector<char> is_constrained; // by the caller or for a face outside of the region, not by a condition
  std::vector<char> is_held;        // these, and those of a border or a line that is fixed
  Culprit culprit;                  // of the last error

private:
  Progress* m_progress; // of the solver that owns this

public:
  Filter(std::unique_ptr<Any_linear_solver> solver, Progress& progress)
    : system(std::move(solver))
    , m_progress(&progress)
  {
  }

  const Indexed_triangles& mesh() const { return system.mesh; }
  Progress& progress() { return *m_progress; }

  // At the beginning of every stage the visitor is asked.
  Error_code ready() { return m_progress->go_on() ? ok : error_cancelled; }

  void constrain(std::vector<char> constrained);

  bool is_moved(int v) const { return mesh().corners.size(v) > 0 && !is_held[v]; }

  // gamma |hess g|^2, in units of the arrays; 0 for none
  void set_second_order(double weight, Hessian_kind kind);

  // The volume has a meaning where all of a closed and oriented mesh moves freely.
  bool encloses_volume() const;

  // Every stretch in units of the arrays.
  Error_code set_curvature_metric(const std::vector<Principal_curvatures>& curvatures, const Stretch& stretch);

  // At the vertices, by jets fitted to presmoothed positions.
  template <class Void = void>
  Error_code estimate_by_jets(const Curvature_options& options, std::vector<Principal_curvatures>& curvatures);

  // At the triangles.
  template <class Void = void>
  Error_code estimate(const Curvature_options& options, std::vector<Principal_curvatures>& curvatures);

  // The change of every vertex.
  template <class Target_field>
  Error_code solve(const Target_field& target, Signal& change);

  // Adds a change to the rows of all vertices: those of a seam go on differing as they did.
  void add(const Signal& change, Signal& signal) const;

  template <class Void = void>
  Error_code filter(Signal& signal);

  // One pass over the positions in the arrays.
  Error_code filter_points();

  // The change by vertex of a signal by vertex.
  Error_code solve_by_vertex(const Signal& signal, Signal& change);

  void move_points(const Signal& change);

private:
  // Vertices under a condition are constrained on the surface; unless they are fixed they move with their curve.
  void hold(Border_condition condition, const std::vector<char>& is_on_curve, std::vector<char>& constrained);

  // A copy for estimating curvatures: smoothed with the metric of the embedding, by vertex. The system's own metric and
  // weights come back, whatever happens.
  template <class Void = void>
  Error_code presmooth(double weight, Signal& signal);

  struct Scaled_difference_of_vertices;
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/filtering/Filter_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_H
