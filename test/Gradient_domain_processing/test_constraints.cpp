// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Constrained vertices: kept to the bit, the Dirichlet problem around them, and what happens where none is.

#include "test_energy.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/operators.h>
#include <CGAL/Gradient_domain_processing/process_signal.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <vector>

namespace GDP = CGAL::Gradient_domain_processing;
using namespace gdp_test;

// Every run has the same parameters, with other values.
struct Settings
{
  double value_weight = 1, gradient_weight = 0.01, gradient_scale = 0;
  std::vector<Vertex> constrained;
};

GDP::Error_code run(Mesh& mesh, const Settings& settings)
{
  auto map = mesh.add_property_map<Vertex, bool>("v:constrained", false).first;
  for(Vertex v : settings.constrained)
    map[v] = true;
  const GDP::Error_code code = GDP::smooth(mesh, GDP::parameters::vertex_is_constrained_map(map)
                                                   .value_weight(settings.value_weight)
                                                   .gradient_weight(settings.gradient_weight)
                                                   .gradient_scale(settings.gradient_scale)
                                                   .area_normalization(false));
  mesh.remove_property_map(map);
  return code;
}

// The same with the matrices of the package and a dense solver.
Eigen::MatrixXd expected(const Mesh& mesh, const Settings& settings)
{
  Eigen::SparseMatrix<double> m, s;
  GDP_CHECK(GDP::mass_matrix(mesh, m) == GDP::OK);
  GDP_CHECK(GDP::stiffness_matrix(mesh, s) == GDP::OK);
  std::vector<char> is_fixed(mesh.number_of_vertices(), 0);
  for(Vertex v : settings.constrained)
    is_fixed[v] = 1;
  const Eigen::MatrixXd mass = settings.value_weight * Eigen::MatrixXd(m),
                        stiffness = settings.gradient_weight * Eigen::MatrixXd(s);
  const Eigen::MatrixXd f = positions(mesh);
  return Dense_energy::dirichlet(mass + stiffness, mass * f + settings.gradient_scale * stiffness * f, f, is_fixed);
}

void check(const Shape& shape, const Settings& settings, double tolerance = 1e-12)
{
  const Mesh before = mesh_of(shape);
  Mesh mesh = before;
  GDP_CHECK(run(mesh, settings) == GDP::OK);
  for(Vertex v : settings.constrained)
    GDP_CHECK(same_bits(mesh.point(v), before.point(v)));
  const double error = (positions(mesh) - expected(before, settings)).cwiseAbs().maxCoeff();
  GDP_CHECK_NEAR(error, 0, tolerance);
  if(settings.constrained.size() < mesh.number_of_vertices())
    GDP_CHECK(distance(mesh, before) > 1e-6);
}

void check_error(const Shape& shape, const Settings& settings, GDP::Error_code code)
{
  const Mesh before = mesh_of(shape);
  Mesh mesh = before;
  GDP_CHECK(run(mesh, settings) == code);
  GDP_CHECK(same_points(mesh, before));
}

void test_positions()
{
  const Shape ball = sphere(4).noisy(0.05), patch = jittered_square(6).noisy(0.05).moved(Vec(3, 0, 0));
  const int n = int(ball.points.size());
  for(double scale : {0., 0.5, 2.})
  {
    check(ball, {1, 0.01, scale, {Vertex(3)}});
    check(ball, {1, 0.3, scale, {Vertex(0), Vertex(5), Vertex(6), Vertex(20)}});
    check(ball + patch, {2, 0.1, scale, {Vertex(1), Vertex(n), Vertex(n + 20)}});
    check(ball + patch, {1, 0.1, scale, {}});

    // nothing but gradients: one constrained vertex in each component suffices
    check(ball, {0, 0.01, scale, {Vertex(3), Vertex(40)}}, 1e-11);
    check(ball + patch, {0, 0.1, scale, {Vertex(1), Vertex(2), Vertex(n), Vertex(n + 20)}}, 1e-11);
  }
  // with a single one and no gradients wanted, everything goes there
  Mesh mesh = mesh_of(ball);
  const Point target = mesh.point(Vertex(7));
  GDP_CHECK(run(mesh, {0, 1, 0, {Vertex(7)}}) == GDP::OK);
  for(Vertex v : mesh.vertices())
    GDP_CHECK_NEAR((vec(mesh.point(v)) - vec(target)).norm(), 0, 1e-12);

  // all constrained
  const Mesh before = mesh_of(ball + patch);
  mesh = before;
  GDP_CHECK(run(mesh, {1, 1, 3, std::vector<Vertex>(before.vertices().begin(), before.vertices().end())}) == GDP::OK);
  GDP_CHECK(same_points(mesh, before));
  GDP_CHECK(run(mesh, {0, 1, 3, std::vector<Vertex>(before.vertices().begin(), before.vertices().end())}) == GDP::OK);
  GDP_CHECK(same_points(mesh, before));

  // to the bit also where scaling by a power of two and back is needed, far from the origin, with negative zero
  for(double size : {1e-150, 1e-9, 1., 3e7, 1e140})
  {
    Mesh scaled = mesh_of((ball + patch).scaled(size).moved(Vec(size / 3, -7 * size, 0)));
    scaled.point(Vertex(4)) = Point(-0., -0., size);
    const Mesh original = scaled;
    std::vector<Vertex> every_third;
    for(unsigned int v = 0; v < original.number_of_vertices(); v += 3)
      every_third.push_back(Vertex(v + 1));
    every_third.pop_back();
    GDP_CHECK(run(scaled, {1, size * size * 0.1, 0, every_third}) == GDP::OK);
    for(Vertex v : every_third)
      GDP_CHECK(same_bits(scaled.point(v), original.point(v)));
    GDP_CHECK(distance(scaled, original) > 1e-3 * size);
  }
}

void test_linear_precision()
{
  // harmonic with a linear border is linear, on any triangulation
  Mesh mesh = mesh_of(jittered_square(12, 0.4));
  auto f = mesh.add_property_map<Vertex, double>("v:f", 0.).first;
  auto g = mesh.add_property_map<Vertex, double>("v:g", 0.).first;
  auto is_border = mesh.add_property_map<Vertex, bool>("v:border", false).first;
  const auto linear = [&](Vertex v) { return 2 + 3 * mesh.point(v).x() - 5 * mesh.point(v).y(); };
  Random random;
  for(Vertex v : mesh.vertices())
  {
    is_border[v] = mesh.is_border(v);
    f[v] = is_border[v] ? linear(v) : random();
  }
  GDP_CHECK(GDP::process_signal(mesh, f, g, GDP::parameters::vertex_is_constrained_map(is_border).value_weight(0))
            == GDP::OK);
  for(Vertex v : mesh.vertices())
  {
    GDP_CHECK_NEAR(g[v], linear(v), 1e-12);
    if(is_border[v])
      GDP_CHECK(same_bits(g[v], f[v]));
  }
}

void test_missing_constraints()
{
  const Shape ball = sphere(3), second = sphere(2).moved(Vec(5, 0, 0)), third = square(3).moved(Vec(0, 5, 0));
  const Shape all = ball + second + third;
  const Vertex in_first(2), in_second(int(ball.points.size()) + 3), in_third(int((ball + second).points.size()) + 1);

  check_error(ball, {0, 1, 0, {}}, GDP::ERROR_UNCONSTRAINED);
  check_error(all, {0, 1, 0, {}}, GDP::ERROR_UNCONSTRAINED);
  check_error(all, {0, 1, 0, {in_first}}, GDP::ERROR_UNCONSTRAINED);
  check_error(all, {0, 1, 0, {in_first, in_third}}, GDP::ERROR_UNCONSTRAINED);
  check_error(all, {0, 1, 0, {in_second, in_third}}, GDP::ERROR_UNCONSTRAINED);
  check(all, {0, 1, 0, {in_first, in_second, in_third}}, 1e-11);

  // alpha and beta both zero: nothing acts, nothing moves
  Mesh mesh = mesh_of(all);
  const Mesh before = mesh;
  GDP_CHECK(run(mesh, {0, 0, 0, {}}) == GDP::OK);
  GDP_CHECK(same_points(mesh, before));
  GDP_CHECK(run(mesh, {1, 0, 0, {}}) == GDP::OK);
  GDP_CHECK(same_points(mesh, before));
}

// alpha at vertices and beta on faces, zero in places
void test_masks_of_zeros()
{
  const Shape ball = sphere(4).noisy(0.05), patch = jittered_square(8).noisy(0.03).moved(Vec(3, 0, 0));
  Mesh mesh = mesh_of(ball + patch);
  const int n = int(ball.points.size());
  auto in = mesh.add_property_map<Vertex, Point>("v:in").first;
  auto out = mesh.add_property_map<Vertex, Point>("v:out").first;
  auto alpha = mesh.add_property_map<Vertex, double>("v:alpha", 0.).first;
  auto beta = mesh.add_property_map<Face, double>("f:beta", 0.1).first;
  auto is_constrained = mesh.add_property_map<Vertex, bool>("v:constrained", false).first;
  for(Vertex v : mesh.vertices())
    in[v] = mesh.point(v);
  const Point untouched(17, 17, 17);
  const auto run = [&] {
    for(Vertex v : mesh.vertices())
      out[v] = untouched;
    return GDP::process_signal(mesh, in, out,
                               GDP::parameters::vertex_value_weight_map(alpha)
                                 .face_gradient_weight_map(beta)
                                 .vertex_is_constrained_map(is_constrained)
                                 .area_normalization(false));
  };
  const auto check = [&] {
    GDP_CHECK(run() == GDP::OK);
    Dense_energy energy(mesh);
    for(Vertex v : mesh.vertices())
    {
      energy.alpha[v] = alpha[v];
      energy.is_fixed[v] = is_constrained[v];
      if(is_constrained[v])
        GDP_CHECK(same_bits(out[v], in[v]));
    }
    for(Face f : mesh.faces())
      energy.beta[f] = beta[f];
    const Eigen::MatrixXd g = energy.minimum(positions(mesh));
    double error = 0;
    for(Vertex v : mesh.vertices())
      error = (std::max)(error, (vec(out[v]) - Vec(g.row(v).transpose())).norm());
    GDP_CHECK_NEAR(error, 0, 1e-11);
  };
  const auto check_unconstrained = [&] {
    GDP_CHECK(run() == GDP::ERROR_UNCONSTRAINED);
    for(Vertex v : mesh.vertices())
      GDP_CHECK(same_bits(out[v], untouched));
  };

  check_unconstrained();
  alpha[Vertex(11)] = 1; // holds the ball, not the patch
  check_unconstrained();
  is_constrained[Vertex(n + 3)] = true;
  check();
  is_constrained[Vertex(n + 3)] = false;
  alpha[Vertex(n + 30)] = 0.3;
  check();

  // the patch has neither: it stays where it is, to the bit
  alpha[Vertex(n + 30)] = 0;
  for(Face f : mesh.faces())
    if(int(corners(mesh, f)[0]) >= n)
      beta[f] = 0;
  check();
  for(Vertex v : mesh.vertices())
    GDP_CHECK((int(v) >= n) == same_bits(out[v], in[v]));

  // stiff faces on a part of the patch only, held by nothing; then by one vertex; and the rest still stays
  for(Face f : mesh.faces())
    if(int(corners(mesh, f)[0]) >= n && mesh.point(corners(mesh, f)[0]).x() < 3.3)
      beta[f] = 0.1;
  check_unconstrained();
  is_constrained[Vertex(n)] = true;
  check();
  for(Vertex v : mesh.vertices())
    if(mesh.point(v).x() > 3.6)
      GDP_CHECK(same_bits(out[v], in[v]));

  // values without gradients: a mass matrix that is singular where no alpha is
  for(Face f : mesh.faces())
    beta[f] = 0;
  GDP_CHECK(run() == GDP::OK);
  for(Vertex v : mesh.vertices())
    GDP_CHECK(same_bits(out[v], in[v]));
}

int main()
{
  test_positions();
  test_linear_precision();
  test_missing_constraints();
  test_masks_of_zeros();
  return GDP_TEST_RESULT();
}
