// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Filtered signals against the answers of data/make_references.py, through process_signal(), smooth() and sharpen().

#include "reference_data.h"

#include <CGAL/Gradient_domain_processing/process_signal.h>
#include <CGAL/Gradient_domain_processing/sharpen.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <cmath>
#include <string>
#include <vector>

using namespace gdp_test;

namespace {

// The answers have 17 digits, the systems are mildly conditioned: what is measured is near 1e-14, so a digit lost to
// another compiler or another BLAS does no harm, and anything wrong with the mathematics is far above it.
const double tolerance = 1e-10;

template <class Region, class NamedParameters>
double error_of_signal(const Case& c, const Mesh& tm, const Region& region, const NamedParameters& np)
{
  const Table answer = read_table(c.name);
  GDP::Error_code code = GDP::OK;
  double error = HUGE_VAL;
  if(c.columns == 1)
  {
    std::vector<double> values;
    for(const auto& row : read_table(c.mesh + "_input_scalar"))
      values.push_back(row.at(0));
    const auto map = CGAL::make_property_map(values);
    code = region(tm, map, np);
    error = relative_error(values, answer);
  }
  else
  {
    std::vector<Vector> values;
    if(c.text("signal") == "normal")
      values = as_vectors(read_table(c.mesh + "_vertex_normals"));
    else
      for(Vertex v : vertices(tm))
        values.push_back(tm.point(v) - CGAL::ORIGIN);
    code = region(tm, CGAL::make_property_map(values), np);
    error = relative_error(values, answer);
  }
  GDP_CHECK(code == GDP::OK);
  return error;
}

const auto on_all = [](const Mesh& tm, auto map, const auto& np) { return GDP::process_signal(tm, map, map, np); };

void check_case(const Case& c, Error_log& log)
{
  Mesh tm = read_mesh(c.mesh);
  const double alpha = c.number("alpha", 1), beta = c.number("beta", 0), lambda = c.number("lambda", 0);
  const auto weights = GDP::parameters::value_weight(alpha).gradient_weight(beta).area_normalization(c.is_relative());
  const auto scalars = weights.gradient_scale(lambda);
  const bool is_position = c.text("signal") == "position";
  const bool is_of_user = c.text("metric") == "user";

  if(c.text("region") == "file")
  {
    std::vector<Face> region;
    for(const auto& row : read_table(c.mesh + "_input_region"))
      region.emplace_back(Mesh::size_type(row.at(0)));
    log.check(c, error_of_signal(c, tm, [&](const Mesh& m, auto map, const auto& np) {
      return GDP::process_signal(region, m, map, map, np); }, scalars), tolerance);
    GDP_CHECK((lambda == 0 ? GDP::smooth(region, tm, weights) : GDP::sharpen(region, tm, weights)) == GDP::OK);
    log.check(c, relative_error(tm, read_table(c.name)), tolerance);
    return;
  }

  if(c.metric_kind() != GDP::Curvature_metric_kind::EMBEDDING)
  {
    const auto curved = scalars.curvature_metric_kind(c.metric_kind())
                          .curvature_weight(c.number("eps", 0))
                          .curvature_estimator(GDP::Curvature_estimator::NORMALS)
                          .presmoothing_weight(c.number("gamma", 0));
    log.check(c, error_of_signal(c, tm, on_all, curved), tolerance);
    if(is_position)
    {
      GDP_CHECK(GDP::smooth(tm, curved) == GDP::OK);
      log.check(c, relative_error(tm, read_table(c.name)), tolerance);
    }
    return;
  }

  // every weight and the metric as a map
  {
    auto alphas = tm.add_property_map<Vertex, double>("v:alpha", alpha).first;
    auto constrained = tm.add_property_map<Vertex, bool>("v:constrained", false).first;
    auto betas = tm.add_property_map<Face, double>("f:beta", beta).first;
    auto lambdas = tm.add_property_map<Face, double>("f:lambda", lambda).first;
    Mesh::Property_map<Face, GDP::Triangle_metric> metrics;
    face_metrics(c.mesh, is_of_user, tm, metrics);
    const auto va = c.triple("vertex_alpha"), fb = c.triple("face_beta"), fl = c.triple("face_lambda");
    for(Vertex v : vertices(tm))
    {
      if(c.has("vertex_alpha"))
        alphas[v] = va[1] + va[2] * (int(v) % int(va[0]));
      if(c.has("constrained"))
        constrained[v] = int(v) % int(c.number("constrained", 1)) == 0;
    }
    for(Face f : faces(tm))
    {
      if(c.has("face_beta"))
        betas[f] = int(f) % int(fb[0]) == 0 ? fb[1] : fb[2];
      if(c.has("face_lambda"))
        lambdas[f] = int(f) % int(fl[0]) == 0 ? fl[1] : fl[2];
    }
    log.check(c,
              error_of_signal(c, tm, on_all,
                              GDP::parameters::vertex_value_weight_map(alphas)
                                .face_gradient_weight_map(betas)
                                .face_gradient_scale_map(lambdas)
                                .vertex_is_constrained_map(constrained)
                                .face_metric_map(metrics)
                                .area_normalization(c.is_relative())),
              tolerance);
  }

  // as numbers, where they are
  if(is_of_user || c.has("vertex_alpha") || c.has("face_beta") || c.has("face_lambda") || c.has("constrained"))
    return;
  log.check(c, error_of_signal(c, tm, on_all, scalars), tolerance);

  // by the verbs, whose lambda is the default
  if(is_position && (lambda == 0 || lambda == 2))
  {
    GDP_CHECK((lambda == 0 ? GDP::smooth(tm, weights) : GDP::sharpen(tm, weights)) == GDP::OK);
    log.check(c, relative_error(tm, read_table(c.name)), tolerance);
  }
}

} // namespace

int main()
{
  Error_log log;
  int cases = 0;
  for(const Case& c : read_cases())
    if(c.kind == "process")
    {
      check_case(c, log);
      ++cases;
    }
  log.print();
  GDP_CHECK(cases >= 100);
  return GDP_TEST_RESULT();
}
