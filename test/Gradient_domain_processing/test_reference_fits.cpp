// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// fit_to_gradients(), fit_to_normals() and stitch() against the answers of data/make_references.py.

#include "reference_data.h"

#include <CGAL/Gradient_domain_processing/fit_to_gradients.h>
#include <CGAL/Gradient_domain_processing/fit_to_normals.h>
#include <CGAL/Gradient_domain_processing/stitch.h>

#include <array>
#include <vector>

using namespace gdp_test;

namespace {

// What is measured is near 1e-13. Stitching, with so little alpha that the constants of the patches are all but free,
// loses some digits more: what is measured is near 1e-11.
const double tolerance = 1e-10, tolerance_of_stitching = 1e-9;

void check_gradients(const Case& c, Error_log& log)
{
  Mesh tm = read_mesh(c.mesh);
  Mesh::Property_map<Face, GDP::Triangle_metric> metrics;
  face_metrics(c.mesh, c.text("metric") == "user", tm, metrics);
  auto targets = tm.add_property_map<Face, std::array<Vector, 3> >("f:target").first;
  const Table rows = read_table(c.mesh + "_input_target");
  for(Face f : faces(tm))
  {
    const auto& row = rows.at(f);
    // what is normal to the face does not count
    const auto p = corners(tm, f);
    const Eigen::Vector3d n = (p[1] - p[0]).cross(p[2] - p[0]);
    for(int i = 0; i < 3; ++i)
      targets[f][i] = Vector(row.at(3 * i), row.at(3 * i + 1), row.at(3 * i + 2)) + (i + 1) * Vector(n[0], n[1], n[2]);
  }
  std::vector<Vector> values;
  for(Vertex v : vertices(tm))
    values.push_back(tm.point(v) - CGAL::ORIGIN);
  const auto map = CGAL::make_property_map(values);
  GDP_CHECK(GDP::fit_to_gradients(tm, map, targets, map,
    GDP::parameters::value_weight(c.number("alpha", 1)).gradient_weight(c.number("beta", 0))
      .area_normalization(c.is_relative()).face_metric_map(metrics)) == GDP::OK);
  log.check(c, relative_error(values, read_table(c.name)), tolerance);
}

void check_normals(const Case& c, Error_log& log)
{
  Mesh tm = read_mesh(c.mesh);
  auto normals = tm.add_property_map<Vertex, Vector>("v:normal").first;
  const auto given = as_vectors(read_table(c.mesh + "_vertex_normals"));
  for(Vertex v : vertices(tm))
    normals[v] = given.at(v);
  const auto np = GDP::parameters::gradient_weight(c.number("beta", 0))
                    .normal_projection_weight(c.number("npweight", 0))
                    .normal_fit_kind(GDP::Normal_fit_kind::EDGES)
                    .area_normalization(c.is_relative())
                    .curvature_metric_kind(c.metric_kind())
                    .curvature_weight(c.number("eps", 0))
                    .presmoothing_weight(c.number("gamma", 0))
                    .curvature_estimator(GDP::Curvature_estimator::NORMALS);
  const double lambda = c.number("lambda", 1);
  // with lambda = 1 the normals are used as given: that is the default
  GDP_CHECK((lambda == 1 ? GDP::fit_to_normals(tm, normals, np)
                         : GDP::fit_to_normals(tm, normals, np.gradient_scale(lambda))) == GDP::OK);
  log.check(c, relative_error(tm, read_table(c.name)), tolerance);
}

void check_stitch(const Case& c, Error_log& log)
{
  Mesh tm = read_mesh(c.mesh);
  Mesh::Property_map<Face, GDP::Triangle_metric> metrics;
  face_metrics(c.mesh, c.text("metric") == "user", tm, metrics);
  std::vector<int> patches;
  for(const auto& row : read_table(c.mesh + "_input_patches"))
    patches.push_back(int(row.at(0)));
  std::vector<double> values;
  for(const auto& row : read_table(c.mesh + "_input_stitch"))
    values.push_back(row.at(0));
  const auto map = CGAL::make_property_map(values);
  GDP_CHECK(GDP::stitch(tm, CGAL::make_property_map(patches), map, map,
    GDP::parameters::value_weight(c.number("alpha", 1)).gradient_weight(c.number("beta", 0))
      .area_normalization(c.is_relative()).face_metric_map(metrics)) == GDP::OK);
  log.check(c, relative_error(values, read_table(c.name)), tolerance_of_stitching);
}

} // namespace

int main()
{
  Error_log log;
  for(const Case& c : read_cases())
    if(c.kind == "fit_to_gradients")
      check_gradients(c, log);
    else if(c.kind == "fit_to_normals")
      check_normals(c, log);
    else if(c.kind == "stitch")
      check_stitch(c, log);
  log.print();
  GDP_CHECK(log.count("fit_to_gradients") == 8);
  GDP_CHECK(log.count("fit_to_normals") == 16);
  GDP_CHECK(log.count("stitch") == 8);
  return GDP_TEST_RESULT();
}
