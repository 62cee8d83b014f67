// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Operators, normals and curvatures against the answers of data/make_references.py.

#include "reference_data.h"

#include <CGAL/Gradient_domain_processing/curvature_metric.h>
#include <CGAL/Gradient_domain_processing/operators.h>
#include <CGAL/Gradient_domain_processing/process_signal.h>

#include <Eigen/Dense>

#include <string>
#include <utility>
#include <vector>

using namespace gdp_test;

namespace {

// What is measured is near 1e-15.
const double tolerance = 1e-12;

// Products with t1 and t2 of every face, in rows 2 f and 2 f + 1; vectors in columns 3 f to 3 f + 2.
Eigen::MatrixXd products_with_sides(const Mesh& tm, bool in_the_order_of_the_file)
{
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(2 * num_faces(tm), 3 * num_faces(tm));
  std::ifstream file("data/patch.off");
  std::string word;
  std::size_t number;
  file >> word >> number >> number >> number;
  Eigen::MatrixXd points(num_vertices(tm), 3);
  for(Eigen::Index i = 0; i < points.rows(); ++i)
    file >> points(i, 0) >> points(i, 1) >> points(i, 2);
  for(Face f : faces(tm))
  {
    std::array<Eigen::Vector3d, 3> p = corners(tm, f);
    int three = 0, v[3] = {0, 0, 0};
    file >> three >> v[0] >> v[1] >> v[2];
    GDP_CHECK(three == 3);
    if(in_the_order_of_the_file)
      for(int i = 0; i < 3; ++i)
        p[i] = points.row(v[i]).transpose();
    result.block<1, 3>(2 * int(f), 3 * int(f)) = (p[1] - p[0]).transpose();
    result.block<1, 3>(2 * int(f) + 1, 3 * int(f)) = (p[2] - p[0]).transpose();
  }
  GDP_CHECK(bool(file));
  return result;
}

void check_matrix(const Case& c, Error_log& log)
{
  Mesh tm = read_mesh(c.mesh);
  std::string name = c.text("operator");
  const std::string suffix = "_user_metric";
  const bool of_user =
    name.size() > suffix.size() && name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0;
  if(of_user)
    name.resize(name.size() - suffix.size());
  Mesh::Property_map<Face, GDP::Triangle_metric> metrics;
  face_metrics(c.mesh, of_user, tm, metrics);

  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(c.rows, c.columns);
  for(const auto& row : read_table(c.name))
    expected(int(row.at(0)), int(row.at(1))) = row.at(2);

  const Eigen::MatrixXd sides = products_with_sides(tm, false);
  // once under the metric of the map and, where that is the embedding's, once without it
  for(int with_map = 0; with_map < (of_user ? 1 : 2); ++with_map)
  {
    const auto np = GDP::parameters::face_metric_map(metrics);
    Eigen::SparseMatrix<double> found;
    GDP::Error_code code = GDP::ERROR_EMPTY_MESH;
    Eigen::MatrixXd right = expected;
    if(name == "mass")
      code = with_map == 0 ? GDP::mass_matrix(tm, found, np) : GDP::mass_matrix(tm, found);
    else if(name == "stiffness")
      code = with_map == 0 ? GDP::stiffness_matrix(tm, found, np) : GDP::stiffness_matrix(tm, found);
    else if(name == "gradient")
    {
      code = with_map == 0 ? GDP::gradient_matrix(tm, found, np) : GDP::gradient_matrix(tm, found);
      right = sides * expected;
    }
    else
      code = with_map == 0 ? GDP::divergence_matrix(tm, found, np) : GDP::divergence_matrix(tm, found);
    GDP_CHECK(code == GDP::OK);
    Eigen::MatrixXd left = Eigen::MatrixXd(found);
    if(name == "divergence")
      left = left * sides;
    else if(name == "divergence_covector")
    {
      left = left * sides; // of vectors in space, as the sides are not those of the file
      right = right * products_with_sides(tm, true);
    }
    const bool fits = left.rows() == right.rows() && left.cols() == right.cols();
    log.check(c, fits ? (left - right).cwiseAbs().maxCoeff() / right.cwiseAbs().maxCoeff() : HUGE_VAL, tolerance);
  }
}

// Area-weighted vertex normals, through the array-level code that all functions use.
void check_vertex_normals(const Case& c, Error_log& log)
{
  const Mesh tm = read_mesh(c.mesh);
  auto solver = GDP::make_gradient_domain_solver(tm);
  const auto found = solver.arrays().system.mesh.vertex_normals(false);
  std::vector<Vector> normals(found.size());
  for(std::size_t i = 0; i < found.size(); ++i)
    normals[solver.elements().vertices[i]] = Vector(found[i][0], found[i][1], found[i][2]);
  log.check(c, relative_error(normals, read_table(c.name)), tolerance);
}

void check_smoothed_normals(const Case& c, Error_log& log)
{
  const Mesh tm = read_mesh(c.mesh);
  std::vector<Vector> normals = as_vectors(read_table(c.mesh + "_vertex_normals"));
  const auto map = CGAL::make_property_map(normals);
  GDP_CHECK(GDP::process_signal(tm, map, map, GDP::parameters::gradient_weight(c.number("gamma", 0))) == GDP::OK);
  for(Vector& n : normals)
    n = n / std::sqrt(n.squared_length());
  log.check(c, relative_error(normals, read_table(c.name)), tolerance);
}

// Writes down the curvatures that it is asked about.
struct Recording_stretch
{
  std::vector<std::pair<double, double> >* seen;
  std::pair<double, double> operator()(double k1, double k2) const
  {
    seen->emplace_back(k1, k2);
    return {1., 1.};
  }
};

void check_face_curvatures(const Case& c, Error_log& log)
{
  Mesh tm = read_mesh(c.mesh);
  std::vector<std::pair<double, double> > seen;
  auto metrics = tm.add_property_map<Face, GDP::Triangle_metric>("f:metric").first;
  GDP_CHECK(GDP::curvature_metric(tm, metrics, GDP::parameters::curvature_metric_kind(Recording_stretch{&seen})
    .curvature_estimator(GDP::Curvature_estimator::NORMALS).presmoothing_weight(c.number("gamma", 0))
    .area_normalization(c.is_relative()).concurrency_tag(CGAL::Sequential_tag())) == GDP::OK);
  const auto solver = GDP::make_gradient_domain_solver(tm); // knows in which order the faces are asked for
  std::vector<std::pair<double, double> > curvatures(seen.size());
  GDP_CHECK(seen.size() == solver.elements().faces.size());
  for(std::size_t i = 0; i < seen.size(); ++i)
    curvatures[solver.elements().faces[i]] = seen[i];
  log.check(c,
            relative_error(curvatures, read_table(c.name),
                           [](const std::pair<double, double>& k, int i) { return i == 0 ? k.first : k.second; }),
            tolerance);
}

} // namespace

int main()
{
  Error_log log;
  for(const Case& c : read_cases())
    if(c.kind == "matrix")
      check_matrix(c, log);
    else if(c.kind == "vertex_normals")
      check_vertex_normals(c, log);
    else if(c.kind == "smoothed_normals")
      check_smoothed_normals(c, log);
    else if(c.kind == "face_curvatures")
      check_face_curvatures(c, log);
  log.print();
  GDP_CHECK(log.count("matrix") == 14);
  GDP_CHECK(log.count("vertex_normals") == 4);
  GDP_CHECK(log.count("smoothed_normals") == 4);
  GDP_CHECK(log.count("face_curvatures") == 4);
  return GDP_TEST_RESULT();
}
