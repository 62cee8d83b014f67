// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Prepared_filter.h"
#include "Filter_model.h"
#include "filter_parts.h"

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>

#include <optional>
#include <utility>

using namespace filter_mesh_impl;

struct Prepared_filter::Solver
{
  typedef GDP::Gradient_domain_solver<GDP::internal::Polygon_soup<const std::vector<Point>, Polygons> > Domain_solver;

  Stage_clock clock{false};
  Options options;
  Mesh_file file;
  Filter_input input;
  std::vector<double> scales;
  std::vector<Vector> normals;
  std::optional<Domain_solver> solver;
  std::optional<Filter_settings> last;
  int number_of_solutions = 0;
  std::string why_unchanged;

  Solver(const Options& o, Mesh_file painted)
    : options(o), file(std::move(painted)), input(options, file),
      scales(at_faces(options, file, options.gradient_scale_property)), normals(vertex_normals_of_file(file))
  {}

  Error_code prepare(double gradient_weight)
  {
    const std::vector<Point>& points = file.points;
    const auto np = common_parameters(options, input, clock, GDP::Default_sparse_linear_solver())
      .gradient_weight(gradient_weight)
      .face_gradient_scale_map(Weight_map{scales.empty() ? nullptr : &scales, 0});
    if(input.has_region)
      solver.emplace(GDP::make_gradient_domain_solver(input.region, points, file.polygons, np));
    else
      solver.emplace(GDP::make_gradient_domain_solver(points, file.polygons, np));
    return solver->error();
  }

  Error_code set_metric(const Filter_settings& s)
  {
    if(s.metric == GDP::Curvature_metric_kind::EMBEDDING)
      return solver->set_embedding_metric();
    const auto np = common_parameters(options, input, clock, GDP::Default_sparse_linear_solver())
      .curvature_metric_kind(s.metric)
      .curvature_weight(s.curvature_weight)
      .presmoothing_weight(s.presmoothing_weight);
    return normals.empty() ? solver->set_metric_from_parameters(np)
                           : solver->set_metric_from_parameters(np.vertex_normal_map(Array_map<Vector>{&normals}));
  }

  static bool is_same_metric(const Filter_settings& a, const Filter_settings& b)
  {
    return a.metric == b.metric
           && (a.metric == GDP::Curvature_metric_kind::EMBEDDING
               || (a.curvature_weight == b.curvature_weight && a.presmoothing_weight == b.presmoothing_weight));
  }

  Error_code set(const Filter_settings& s, std::vector<Point>& smoothed)
  {
    if(last && last->gradient_weight == s.gradient_weight && is_same_metric(*last, s))
      return GDP::ok;
    Filter_facts facts;
    const Error_code code = in_region(input, facts, [&](const auto&...) { return solve(s, smoothed); });
    if(code == GDP::ok)
      last = s;
    if(!facts.why_unchanged.empty())
      smoothed = file.points;
    why_unchanged = facts.why_unchanged;
    return code;
  }

  Error_code solve(const Filter_settings& s, std::vector<Point>& smoothed)
  {
    if(const Error_code code = solver ? solver->set_gradient_weight(s.gradient_weight) : prepare(s.gradient_weight))
      return code;
    if(!last || !is_same_metric(*last, s))
      if(const Error_code code = set_metric(s))
        return code;
    std::vector<Point> result = file.points;
    if(const Error_code code = solver->filter(Array_map<Point>{&file.points}, Array_map<Point>{&result}))
      return code;
    smoothed = std::move(result);
    ++number_of_solutions;
    return GDP::ok;
  }
};

Prepared_filter::Prepared_filter(const Options& options, Mesh_file file)
  : m_solver(std::make_unique<Solver>(options, std::move(file)))
{}

Prepared_filter::~Prepared_filter() = default;

Error_code Prepared_filter::set(const Filter_settings& settings, std::vector<Point>& smoothed)
{
  return m_solver->set(settings, smoothed);
}

int Prepared_filter::number_of_solutions() const { return m_solver->number_of_solutions; }

const std::string& Prepared_filter::why_unchanged() const { return m_solver->why_unchanged; }

const Stage_clock& Prepared_filter::clock() const { return m_solver->clock; }
