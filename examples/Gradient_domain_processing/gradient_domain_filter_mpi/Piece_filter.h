// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_MPI_PIECE_FILTER_H
#define GRADIENT_DOMAIN_FILTER_MPI_PIECE_FILTER_H

#include "Mesh_piece.h"
#include "Petsc_system.h"

#include "../gradient_domain_filter/Options.h"

#include <CGAL/Gradient_domain_processing/internal/curvature/Principal_curvatures.h>
#include <CGAL/Gradient_domain_processing/internal/energy/Energy_weights.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/Degrees_of_freedom.h>
#include <CGAL/Gradient_domain_processing/internal/metric/Triangle_metrics.h>

#include <string>
#include <vector>

// The energy of the package on the pieces of all ranks: what Filter and Linear_system are on one machine. Signals have
// a row for every local vertex or, where it is said, for every local row.
class Piece_filter
{
public:
  typedef CGAL::Gradient_domain_processing::internal::Signal Signal;
  typedef CGAL::Gradient_domain_processing::internal::Vec3 Vec3;
  typedef CGAL::Gradient_domain_processing::internal::Energy_weights Energy_weights;
  typedef CGAL::Gradient_domain_processing::internal::Triangle_metrics Triangle_metrics;
  typedef CGAL::Gradient_domain_processing::internal::Principal_curvatures Principal_curvatures;

  // By local row; none: not given.
  struct Given
  {
    std::vector<double> is_constrained, value_weights, gradient_weights, gradient_scales;
    Signal normals;
  };

private:
  const Ranks& m_ranks;
  const Options& m_options;
  Mesh_piece& m_piece;
  const Given& m_given;
  double m_squared_length_unit = 1;
  std::vector<char> m_is_constrained;
  CGAL::Gradient_domain_processing::internal::Degrees_of_freedom m_dofs, m_own_dofs;
  std::vector<Global> m_global_number; // of degrees of freedom
  Energy_weights m_weights;
  Triangle_metrics m_metrics;

public:
  int iterations = 0, systems = 0;
  std::string preconditioner;

  Piece_filter(const Ranks& ranks, const Options& options, Mesh_piece& piece, const Given& given);

  // Both throw Failure.
  void filter_positions();
  void filter_signal(Signal& by_row);

private:
  class System;

  void set_constrained();
  void set_weights();
  std::vector<double> at_vertices(const std::vector<double>& by_row) const;
  std::vector<double> at_triangles(const std::vector<double>& by_row, double elsewhere) const;

  void set_metrics();
  std::vector<Principal_curvatures> curvatures_by_jets();
  std::vector<Principal_curvatures> curvatures_by_normals();
  std::vector<Vec3> own_normals(const std::vector<Vec3>& points) const;
  void presmooth(Signal& by_vertex);

  void smooth(System& system);
  void smooth_without_shrinking(System& system);
  void enhance_details();
  Signal by_row(const Signal& by_vertex) const;
  void move_points(const Signal& change);
};

#endif // GRADIENT_DOMAIN_FILTER_MPI_PIECE_FILTER_H
