// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_VIEWER_FILTER_MODEL_H
#define GRADIENT_DOMAIN_VIEWER_FILTER_MODEL_H

#include "Options.h"
#include "Painting.h"
#include "Wavelengths.h"

#include <memory>
#include <string>
#include <vector>

class Prepared_filter;

// What can be chosen in the window; everything else is as in gradient_domain_filter.
struct Filter_settings
{
  Operation operation = Operation::FILTER; // or ENHANCE_DETAILS, DENOISE
  double gradient_weight = 1e-4, gradient_scale = 0;
  CGAL::Gradient_domain_processing::Curvature_metric_kind metric =
    CGAL::Gradient_domain_processing::Curvature_metric_kind::EMBEDDING;
  double curvature_weight = 0.02, presmoothing_weight = 1e-4;
};

// A mesh file and its filtered points, without a screen. What a change of the settings leaves as it was is not done
// again: a new lambda needs no solution, a new beta one factorization, a new metric the curvature as well.
class Filter_model
{
  Mesh_file m_file;
  Wavelengths m_wavelengths;
  Filter_settings m_settings;
  Painting m_painting;
  std::vector<Vector> m_normals;   // of the original
  std::vector<Point> m_smoothed;   // by lambda = 0
  std::vector<Point> m_points;
  std::unique_ptr<Prepared_filter> m_prepared;
  int m_number_of_solutions = 0;
  std::string m_why_unchanged;
  bool m_is_painting_saved = true;

public:
  // Throws Failure where the file cannot be read.
  explicit Filter_model(const std::string& path);
  ~Filter_model();

  const std::string& path() const { return m_file.name; }
  const Polygons& polygons() const { return m_file.polygons; }
  const std::vector<Point>& original_points() const { return m_file.points; }
  const std::vector<Point>& points() const { return m_points; }
  const Wavelengths& wavelengths() const { return m_wavelengths; }
  const Filter_settings& settings() const { return m_settings; }
  const Painting& painting() const { return m_painting; }

  // Why the filter has found nothing to do; empty if it has.
  const std::string& why_unchanged() const { return m_why_unchanged; }

  // How often a system was solved: not for a new lambda.
  int number_of_solutions() const { return m_number_of_solutions; }

  // Filters. Throws Failure where that fails; settings and points are then those before.
  void set(const Filter_settings& settings);

  // A dab shows its effect with the next filter(). The center is on the shown surface.
  bool paint(Brush brush, const Point& center, double radius, bool is_painted = true);
  void wipe_off();
  void filter();

  // How far every vertex has gone along its normal.
  std::vector<double> displacements() const;
  // k1^2 + k2^2 of the surface through these points.
  std::vector<double> curvatures(const std::vector<Point>& points) const;

  // The words after the program's name that do the same. With paint, the input is the file that save_painting() writes.
  std::vector<std::string> command_words(const std::string& output) const;
  // The same for a shell, in lines.
  std::string command(const std::string& output) const;
  std::string painting_path() const;
  bool is_painting_saved() const { return m_is_painting_saved; }
  void save_painting();

  // Does what the command line says and writes the file. Returns, in sentences, what should be known of it. Throws
  // Failure, or Usage_error for a name that is none.
  std::vector<std::string> save(const std::string& output) const;

private:
  Mesh_file painted_file(double gradient_scale) const;
  std::string property(Brush brush) const;
  void solve();
  void run_command();
};

#endif // GRADIENT_DOMAIN_VIEWER_FILTER_MODEL_H
