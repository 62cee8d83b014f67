// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What happens at the border of open meshes: free, fixed, or along the border.

#include "test_energy.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/process_signal.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <iostream>
#include <vector>

namespace GDP = CGAL::Gradient_domain_processing;
using namespace gdp_test;

GDP::Error_code run(Mesh& mesh, GDP::Border_condition condition, double gradient_weight, double gradient_scale = 0,
                    const std::vector<Vertex>& constrained = {}, double value_weight = 1)
{
  auto map = mesh.add_property_map<Vertex, bool>("v:constrained", false).first;
  for(Vertex v : constrained)
    map[v] = true;
  const GDP::Error_code code = GDP::smooth(mesh, GDP::parameters::vertex_is_constrained_map(map)
                                                   .value_weight(value_weight)
                                                   .gradient_weight(gradient_weight)
                                                   .gradient_scale(gradient_scale)
                                                   .border_condition(condition)
                                                   .area_normalization(false));
  mesh.remove_property_map(map);
  return code;
}

// The interior is the minimum of the energy for the border as it came out.
void check_interior(const Mesh& before, const Mesh& after, double gradient_weight, double gradient_scale)
{
  Dense_energy energy(before, 1, gradient_weight, gradient_scale);
  const Eigen::MatrixXd m = energy.mass(), s = energy.stiffness(), f = positions(before), g = positions(after);
  const Eigen::MatrixXd right = m * f + gradient_scale * s * f;
  for(Vertex v : before.vertices())
    energy.is_fixed[v] = before.is_border(v);
  GDP_CHECK_NEAR((Dense_energy::dirichlet(m + s, right, g, energy.is_fixed) - g).cwiseAbs().maxCoeff(), 0, 1e-12);
}

Shape bumpy_disk()
{
  return disk(24, 5).mapped([](const Vec& p) {
    const double r = p.norm();
    return Vec(p + 0.3 * (1 - r) * Vec(0, 0, std::sin(5 * p.x() + p.y())));
  });
}

void test_fixed_and_free()
{
  for(double scale : {0., 3.})
  {
    const Mesh before = mesh_of(bumpy_disk().noisy(0.02));
    Mesh mesh = before;
    GDP_CHECK(run(mesh, GDP::Border_condition::FIXED, 0.05, scale) == GDP::OK);
    for(Vertex v : mesh.vertices())
      GDP_CHECK(before.is_border(v) == same_bits(mesh.point(v), before.point(v)));
    check_interior(before, mesh, 0.05, scale);

    mesh = before;
    GDP_CHECK(run(mesh, GDP::Border_condition::FREE, 0.05, scale) == GDP::OK);
    const Eigen::MatrixXd g = Dense_energy(before, 1, 0.05, scale).minimum(positions(before));
    GDP_CHECK_NEAR((g - positions(mesh)).cwiseAbs().maxCoeff(), 0, 1e-12);
    for(Vertex v : mesh.vertices())
      GDP_CHECK(!same_bits(mesh.point(v), before.point(v)));
  }

  // a fixed border holds its component when values do not count; free, nothing does
  const Mesh before = mesh_of(bumpy_disk());
  Mesh mesh = before;
  GDP_CHECK(run(mesh, GDP::Border_condition::FREE, 0.05, 0, {}, 0) == GDP::ERROR_UNCONSTRAINED);
  GDP_CHECK(run(mesh, GDP::Border_condition::ALONG_BORDER, 0.05, 0, {}, 0) == GDP::ERROR_UNCONSTRAINED);
  GDP_CHECK(same_points(mesh, before));
  GDP_CHECK(run(mesh, GDP::Border_condition::FIXED, 0.05, 0, {}, 0) == GDP::OK);
  double height = 0; // a minimal surface in a planar border, in one step but for the metric
  for(Vertex v : mesh.vertices())
    height = (std::max)(height, std::abs(mesh.point(v).z()));
  GDP_CHECK_NEAR(height, 0, 1e-12);
}

// A regular polygon of n vertices scales by the factor of the one-dimensional energy, which converges to 1 / (1 + t /
// r^2).
void test_circles()
{
  double error[2];
  for(int i : {0, 1})
    for(double radius : {0.1, 1., 30.})
    {
      const int n = 32 << i;
      const double t = 0.2 * radius * radius, h = 2 * radius * std::sin(pi / n), c = std::cos(2 * pi / n);
      const Mesh before = mesh_of(disk(n, 4).scaled(radius).mapped([&](const Vec& p) {
        return Vec(p + Vec(0, 0, radius - p.head<2>().norm() * (1 - 1e-15)));
      }));
      Mesh mesh = before;
      GDP_CHECK(run(mesh, GDP::Border_condition::ALONG_BORDER, t) == GDP::OK);
      check_interior(before, mesh, t, 0);
      const double discrete = 1 / (1 + t * 6 * (1 - c) / (h * h * (2 + c))), smooth = 1 / (1 + t / (radius * radius));
      double largest = 0;
      for(Vertex v : mesh.vertices())
        if(mesh.is_border(v))
        {
          const double found = vec(mesh.point(v)).head<2>().norm() / radius;
          GDP_CHECK_NEAR(found, discrete, 1e-12);
          largest = (std::max)(largest, std::abs(found - smooth));
          GDP_CHECK_NEAR((vec(mesh.point(v)) / radius - vec(before.point(v)) * found / radius).head<2>().norm(), 0,
                         1e-12);
        }
      error[i] = largest;
      GDP_CHECK(largest < 2e-3);
    }
  std::cout << "circle against 1 / (1 + t / r^2): " << error[0] << ", with twice the vertices " << error[1]
            << std::endl;
  GDP_CHECK(error[1] < 0.3 * error[0]);
}

// Straight, planar, and depending on nothing but itself.
void test_border_curves()
{
  Random random;
  // sides that are divided unevenly, corners held
  Shape shape = jittered_square(10).mapped([](const Vec& p) { return Vec(p.x() * p.x(), std::sqrt(p.y()), 0); });
  for(Vec& p : shape.points)
    if(p.x() > 0 && p.x() < 1 && p.y() > 0 && p.y() < 1)
      p.z() = 0.1 * random();
  const Mesh before = mesh_of(shape);
  std::vector<Vertex> corner;
  for(Vertex v : before.vertices())
  {
    const Vec p = vec(before.point(v));
    if((p.x() == 0 || p.x() == 1) && (p.y() == 0 || p.y() == 1))
      corner.push_back(v);
  }
  GDP_CHECK(corner.size() == 4);
  for(double scale : {0., 1.5})
  {
    Mesh mesh = before;
    GDP_CHECK(run(mesh, GDP::Border_condition::ALONG_BORDER, 0.1, scale, corner) == GDP::OK);
    check_interior(before, mesh, 0.1, scale);
    for(Vertex v : corner)
      GDP_CHECK(same_bits(mesh.point(v), before.point(v)));
    for(Vertex v : mesh.vertices())
      if(before.is_border(v)) // a straight line is harmonic, however its vertices are spaced
        GDP_CHECK_NEAR((vec(mesh.point(v)) - vec(before.point(v))).norm(), 0, 1e-15);
      else
        GDP_CHECK(!same_bits(mesh.point(v), before.point(v)));
  }

  // corners free: they are rounded, within the plane
  Mesh rounded = before;
  GDP_CHECK(run(rounded, GDP::Border_condition::ALONG_BORDER, 0.1) == GDP::OK);
  for(Vertex v : rounded.vertices())
    if(before.is_border(v))
      GDP_CHECK(rounded.point(v).z() == 0);
  for(Vertex v : corner)
    GDP_CHECK(!same_bits(rounded.point(v), before.point(v)));

  // another interior, the same border
  Mesh other = before;
  for(Vertex v : other.vertices())
    if(!other.is_border(v))
      other.point(v) = Point(0.5 + 0.3 * random(), 0.5 + 0.3 * random(), random());
  GDP_CHECK(run(other, GDP::Border_condition::ALONG_BORDER, 0.1) == GDP::OK);
  for(Vertex v : other.vertices())
    if(before.is_border(v))
      GDP_CHECK_NEAR((vec(other.point(v)) - vec(rounded.point(v))).norm(), 0, 1e-15);

  // several border curves, and a closed component beside them
  const Shape tube = grid(24, 5, [](double u, double v) {
    return Vec((1 + v) * std::cos(2 * pi * u), (1 + v) * std::sin(2 * pi * u), 3 * v);
  }, true);
  const Mesh two = mesh_of(tube + sphere(3).moved(Vec(9, 0, 0)));
  Mesh mesh = two;
  GDP_CHECK(run(mesh, GDP::Border_condition::ALONG_BORDER, 0.2) == GDP::OK);
  check_interior(two, mesh, 0.2, 0);
  for(Vertex v : mesh.vertices())
    if(two.is_border(v))
      GDP_CHECK(mesh.point(v).z() == two.point(v).z());
}

// Signals have borders, too: along the border, a signal is filtered by its values on the border.
void test_signals()
{
  const int n = 40;
  Mesh mesh = mesh_of(disk(n, 6));
  auto f = mesh.add_property_map<Vertex, double>("v:f", 0.).first;
  auto g = mesh.add_property_map<Vertex, double>("v:g", 0.).first;
  Random random;
  for(Vertex v : mesh.vertices())
    f[v] = mesh.is_border(v) ? std::sin(2 * std::atan2(mesh.point(v).y(), mesh.point(v).x())) : random();
  const auto run = [&](GDP::Border_condition condition) {
    return GDP::process_signal(
      mesh, f, g, GDP::parameters::gradient_weight(0.05).area_normalization(false).border_condition(condition));
  };
  const double h = 2 * std::sin(pi / n), c = std::cos(4 * pi / n);
  const double factor = 1 / (1 + 0.05 * 6 * (1 - c) / (h * h * (2 + c)));
  GDP_CHECK(run(GDP::Border_condition::ALONG_BORDER) == GDP::OK);
  for(Vertex v : mesh.vertices())
    if(mesh.is_border(v))
      GDP_CHECK_NEAR(g[v], factor * f[v], 1e-13);
    else
      GDP_CHECK(g[v] != f[v]);
  GDP_CHECK(run(GDP::Border_condition::FIXED) == GDP::OK);
  for(Vertex v : mesh.vertices())
    GDP_CHECK(mesh.is_border(v) == same_bits(g[v], f[v]));
}

int main()
{
  test_fixed_and_free();
  test_circles();
  test_border_curves();
  test_signals();
  return GDP_TEST_RESULT();
}
