// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The term of second order, in the energy of every function.

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/enhance_details.h>
#include <CGAL/Gradient_domain_processing/hessian_matrix.h>
#include <CGAL/Gradient_domain_processing/mass_matrix.h>
#include <CGAL/Gradient_domain_processing/process_signal.h>
#include <CGAL/Gradient_domain_processing/smooth.h>
#include <CGAL/Gradient_domain_processing/stiffness_matrix.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;

namespace {

typedef Mesh::Property_map<Vertex, double> Signal_map;
using GDP::parameters::gradient_weight;

Mesh square(int n)
{
  return mesh_of(grid(n, n, [](double u, double v) { return Vec(u, v, 0); }));
}

Signal_map signal_of(Mesh& mesh, const std::string& name, const std::function<double(const Point&)>& f)
{
  const Signal_map map = mesh.add_property_map<Vertex, double>(name, 0).first;
  for(Vertex v : mesh.vertices())
    map[v] = f(mesh.point(v));
  return map;
}

Eigen::VectorXd vector_of(const Mesh& mesh, Signal_map map)
{
  Eigen::VectorXd values(Eigen::Index(mesh.number_of_vertices()));
  for(Vertex v : mesh.vertices())
    values[int(v)] = map[v];
  return values;
}

// (alpha M + beta S + gamma Q) g = alpha M f + beta lambda S f, by dense matrices.
void test_equation()
{
  Mesh mesh = mesh_of(sphere(6).scaled(3));
  const Signal_map in = signal_of(mesh, "v:in", [](const Point& p) { return std::sin(3 * p.x()) + p.y() * p.z(); });
  const Signal_map out = signal_of(mesh, "v:out", [](const Point&) { return 0; });
  const double alpha = 1.5, beta = 0.2, lambda = 1.7, gamma = 0.05;
  for(const GDP::Hessian_kind kind : {GDP::Hessian_kind::SQUARED_HESSIAN, GDP::Hessian_kind::CURVED_HESSIAN,
                                      GDP::Hessian_kind::TRACE_FREE_HESSIAN, GDP::Hessian_kind::BILAPLACIAN})
  {
    const auto np = gradient_weight(beta)
                      .value_weight(alpha)
                      .gradient_scale(lambda)
                      .hessian_weight(gamma)
                      .hessian_kind(kind)
                      .area_normalization(false);
    GDP_CHECK(GDP::process_signal(mesh, in, out, np) == GDP::ok);
    Eigen::SparseMatrix<double> m, s, q;
    GDP_CHECK(GDP::mass_matrix(mesh, m) == GDP::ok && GDP::stiffness_matrix(mesh, s) == GDP::ok);
    GDP_CHECK(GDP::hessian_matrix(mesh, kind, q) == GDP::ok);
    const Eigen::MatrixXd matrix = alpha * m + beta * s + gamma * q;
    const Eigen::VectorXd f = vector_of(mesh, in);
    const Eigen::VectorXd g = matrix.ldlt().solve(Eigen::VectorXd(alpha * (m * f) + beta * lambda * (s * f)));
    GDP_CHECK_NEAR((vector_of(mesh, out) - g).cwiseAbs().maxCoeff(), 0, 1e-9);
  }
}

// What is linear costs nothing, whatever the border, where first derivatives bend it; in a region and beside
// constraints, too.
void test_linear()
{
  Mesh mesh = square(12);
  const Signal_map linear = signal_of(mesh, "v:linear", [](const Point& p) { return 3 * p.x() - 2 * p.y() + 1; });
  const Signal_map out = signal_of(mesh, "v:out", [](const Point&) { return 0; });
  const auto np = gradient_weight(0).hessian_weight(0.01);
  const auto distance = [&] { return (vector_of(mesh, out) - vector_of(mesh, linear)).cwiseAbs().maxCoeff(); };
  GDP_CHECK(GDP::process_signal(mesh, linear, out, np) == GDP::ok);
  GDP_CHECK_NEAR(distance(), 0, 1e-11);
  GDP_CHECK(GDP::process_signal(mesh, linear, out, gradient_weight(0.01)) == GDP::ok);
  GDP_CHECK(distance() > 0.05);

  // three constrained corners decide, and nothing else: the plane through them
  const auto is_corner = mesh.add_property_map<Vertex, bool>("v:corner", false).first;
  const Signal_map corners =
    signal_of(mesh, "v:corners", [&](const Point& p) { return std::sin(9 * p.x()) + std::cos(7 * p.y()); });
  int count = 0;
  for(Vertex v : mesh.vertices())
    if(mesh.point(v).x() + mesh.point(v).y() < 0.01 || mesh.point(v).x() - mesh.point(v).y() > 0.99
       || mesh.point(v).y() - mesh.point(v).x() > 0.99)
    {
      is_corner[v] = true;
      corners[v] = linear[v];
      ++count;
    }
  GDP_CHECK(count == 3);
  GDP_CHECK(
    GDP::process_signal(mesh, corners, out,
                        gradient_weight(0).value_weight(0).hessian_weight(1).vertex_is_constrained_map(is_corner))
    == GDP::ok);
  GDP_CHECK_NEAR(distance(), 0, 1e-8);
}

// The weight is a length to the fourth: with the mesh scaled, in its own unit or that of its area, the result is the
// same.
void test_units()
{
  Mesh mesh = mesh_of(sphere(6)), large = mesh_of(sphere(6).scaled(8));
  Mesh normalized = mesh, large_normalized = large;
  const auto np = gradient_weight(0).hessian_weight(1e-4);
  GDP_CHECK(GDP::smooth(mesh, np.area_normalization(false)) == GDP::ok);
  GDP_CHECK(GDP::smooth(large, gradient_weight(0).hessian_weight(1e-4 * 4096).area_normalization(false)) == GDP::ok);
  GDP_CHECK(GDP::smooth(normalized, np) == GDP::ok && GDP::smooth(large_normalized, np) == GDP::ok);
  double scaled = 0, of_area = 0, moved = 0;
  const Mesh before = mesh_of(sphere(6));
  for(Vertex v : mesh.vertices())
  {
    const auto distance = [&](const Mesh& a, double factor, const Mesh& b) {
      return std::sqrt(CGAL::squared_distance(Point(CGAL::ORIGIN + factor * (a.point(v) - CGAL::ORIGIN)), b.point(v)));
    };
    scaled = (std::max)(scaled, distance(mesh, 8, large));
    of_area = (std::max)(of_area, distance(normalized, 8, large_normalized));
    moved = (std::max)(moved, distance(mesh, 1, before));
  }
  GDP_CHECK_NEAR(scaled, 0, 1e-10);
  GDP_CHECK_NEAR(of_area, 0, 1e-10);
  GDP_CHECK(moved > 1e-3);
}

// With and without it, one after the other, on one solver; quads; and what is refused.
void test_switching()
{
  Mesh mesh = square(9);
  const Signal_map in = signal_of(mesh, "v:in", [](const Point& p) { return std::sin(8 * p.x() * p.y()); });
  const Signal_map first = signal_of(mesh, "v:first", [](const Point&) { return 0; });
  const Signal_map second = signal_of(mesh, "v:second", [](const Point&) { return 0; });
  const Signal_map third = signal_of(mesh, "v:third", [](const Point&) { return 0; });
  auto solver = GDP::make_gradient_domain_solver(mesh);
  GDP_CHECK(solver.filter(in, first) == GDP::ok);
  GDP_CHECK(solver.set_weights_from_parameters(gradient_weight(0).hessian_weight(1e-4)) == GDP::ok);
  GDP_CHECK(solver.filter(in, second) == GDP::ok);
  GDP_CHECK(solver.set_weights_from_parameters() == GDP::ok);
  GDP_CHECK(solver.filter(in, third) == GDP::ok);
  GDP_CHECK(vector_of(mesh, first) == vector_of(mesh, third));
  GDP_CHECK((vector_of(mesh, first) - vector_of(mesh, second)).norm() > 1e-3);
  GDP_CHECK(solver.set_weights_from_parameters(GDP::parameters::hessian_weight(-1)) == GDP::error_invalid_weight);
  GDP_CHECK(solver.set_weights_from_parameters(GDP::parameters::hessian_weight(HUGE_VAL)) == GDP::error_invalid_weight);

  // quads: linear functions cost nothing either
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 4> > quads;
  for(int i = 0; i <= 6; ++i)
    for(int j = 0; j <= 6; ++j)
      points.emplace_back(i + 0.2 * ((i * 7 + j * 3) % 5) / 5., j, 0);
  for(std::size_t i = 0; i < 6; ++i)
    for(std::size_t j = 0; j < 6; ++j)
      quads.push_back({{7 * i + j, 7 * i + 7 + j, 7 * i + 8 + j, 7 * i + 1 + j}});
  std::vector<Point> moved = points;
  GDP_CHECK(GDP::smooth(moved, quads, gradient_weight(0).hessian_weight(0.01)) == GDP::ok);
  for(std::size_t v = 0; v < points.size(); ++v)
    GDP_CHECK_NEAR(std::sqrt(CGAL::squared_distance(points[v], moved[v])), 0, 1e-9);

  // other constraints with polygons: the matrix has another pattern
  std::vector<double> values(points.size(), 0);
  const auto map = CGAL::make_property_map(values);
  auto of_quads = GDP::make_gradient_domain_solver(points, quads, gradient_weight(1e-2));
  for(std::size_t v = 0; v < values.size(); ++v)
    values[v] = double(v % 4);
  std::vector<double> result(values.size()), again(values.size());
  GDP_CHECK(of_quads.filter(map, CGAL::make_property_map(result)) == GDP::ok);
  const std::vector<char> is_constrained = [&] {
    std::vector<char> c(points.size(), 0);
    c[10] = c[24] = 1;
    return c;
  }();
  GDP_CHECK(of_quads.set_constraints_from_parameters(
              GDP::parameters::vertex_is_constrained_map(CGAL::make_property_map(is_constrained)))
            == GDP::ok);
  GDP_CHECK(of_quads.filter(map, CGAL::make_property_map(again)) == GDP::ok);
  GDP_CHECK(again[10] == values[10] && again[24] == values[24] && again != result);
  GDP_CHECK(of_quads.set_constraints_from_parameters() == GDP::ok);
  GDP_CHECK(of_quads.filter(map, CGAL::make_property_map(again)) == GDP::ok);
  GDP_CHECK(again == result);
}

// Without values and gradients a plane may tilt until three vertices are constrained.
void test_number_of_constraints()
{
  Mesh mesh = square(6);
  const Signal_map in = signal_of(mesh, "v:in", [](const Point& p) { return std::sin(8 * p.x() * p.y()); });
  const Signal_map out = signal_of(mesh, "v:out", [](const Point&) { return -7; });
  auto is_constrained = mesh.add_property_map<Vertex, bool>("v:is_constrained", false).first;
  const Vertex corners[3] = {Vertex(0), Vertex(6), Vertex(42)};
  const auto filtered = [&](double beta, GDP::Hessian_kind kind) {
    return GDP::process_signal(mesh, in, out, gradient_weight(beta).value_weight(0).hessian_weight(1e-3)
                                 .hessian_kind(kind).gradient_scale(0).vertex_is_constrained_map(is_constrained));
  };
  for(int count = 0; count <= 3; ++count)
  {
    if(count > 0)
      is_constrained[corners[count - 1]] = true;
    GDP_CHECK(filtered(0, GDP::Hessian_kind::SQUARED_HESSIAN) == (count < 3 ? GDP::error_unconstrained : GDP::ok));
    if(count < 3)
      GDP_CHECK(out[Vertex(20)] == -7);
  }
  const double at[3] = {in[corners[0]], in[corners[1]], in[corners[2]]};
  for(Vertex v : mesh.vertices())
    GDP_CHECK_NEAR(out[v], at[0] + (at[1] - at[0]) * mesh.point(v).x() + (at[2] - at[0]) * mesh.point(v).y(), 1e-8);
  GDP_CHECK(filtered(0, GDP::Hessian_kind::TRACE_FREE_HESSIAN) == GDP::error_unconstrained);
  is_constrained[corners[1]] = is_constrained[corners[2]] = false;
  GDP_CHECK(filtered(1e-3, GDP::Hessian_kind::SQUARED_HESSIAN) == GDP::ok);
  GDP_CHECK(filtered(0, GDP::Hessian_kind::BILAPLACIAN) == GDP::ok);
}

// Vertices of quads that nothing acts on stay as they are, beside those that are filtered.
void test_nothing_acts()
{
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 4> > quads;
  std::vector<double> values, value_weights, gradient_weights;
  for(int i = 0; i <= 8; ++i)
    for(int j = 0; j <= 4; ++j)
    {
      points.emplace_back(i, j, 0);
      values.push_back((i * 7 + j * 5) % 4);
      value_weights.push_back(i < 5 ? 1 : 0);
    }
  for(std::size_t i = 0; i < 8; ++i)
    for(std::size_t j = 0; j < 4; ++j)
    {
      quads.push_back({{5 * i + j, 5 * i + 5 + j, 5 * i + 6 + j, 5 * i + 1 + j}});
      gradient_weights.push_back(i < 4 ? 1e-2 : 0);
    }
  const std::vector<double> before = values;
  const auto map = CGAL::make_property_map(values);
  GDP_CHECK(GDP::process_signal(points, quads, map, map,
                                GDP::parameters::vertex_value_weight_map(CGAL::make_property_map(value_weights))
                                  .face_gradient_weight_map(CGAL::make_property_map(gradient_weights))
                                  .gradient_scale(0))
            == GDP::ok);
  for(std::size_t v = 0; v < values.size(); ++v)
  {
    GDP_CHECK(std::isfinite(values[v]));
    if(v >= 5 * 6)
      GDP_CHECK_NEAR(values[v], before[v], 1e-12);
  }
  GDP_CHECK(values[7] != before[7]);
}

} // namespace

int main()
{
  test_equation();
  test_linear();
  test_units();
  test_switching();
  test_number_of_constraints();
  test_nothing_acts();
  return GDP_TEST_RESULT();
}
