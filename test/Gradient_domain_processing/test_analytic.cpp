// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is known in closed form: the shrinking of a sphere, eigenfunctions of flat tori and of the sphere.

#include "test_meshes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/process_signal.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double> K;
typedef CGAL::Surface_mesh<K::Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Face_index Face;

namespace {

// The order of convergence from errors on meshes whose edges get half as long every time.
void check_second_order(const std::vector<double>& errors, double smallest)
{
  for(std::size_t i = 0; i + 1 < errors.size(); ++i)
    GDP_CHECK_NEAR(std::log2(errors[i] / errors[i + 1]), 2, 0.1);
  GDP_CHECK(errors.back() < smallest);
}

// A sphere of radius r shrinks to r / (1 + 2 t / r^2), t = beta / alpha; four refinements.
void check_sphere()
{
  const double r = 2.5, t = 0.7, exact = r / (1 + 2 * t / (r * r));
  std::vector<double> errors;
  for(int level = 1; level <= 5; ++level)
  {
    Mesh tm = built<Mesh>(icosphere(level, r));
    GDP_CHECK(GDP::smooth(tm, GDP::parameters::gradient_weight(3 * t).value_weight(3).area_normalization(false))
              == GDP::OK);
    // in the mean of squares: at the twelve irregular vertices convergence is slower by a logarithm
    double squares = 0, worst = 0;
    for(Vertex v : vertices(tm))
    {
      const double error = std::sqrt((tm.point(v) - CGAL::ORIGIN).squared_length()) / exact - 1;
      squares += error * error;
      worst = (std::max)(worst, std::abs(error));
    }
    errors.push_back(std::sqrt(squares / num_vertices(tm)));
    GDP_CHECK(worst < 2 * std::pow(0.25, level) * (1 + level));
  }
  check_second_order(errors, 1e-4);
}

// Eigenfunctions of the sphere: the spherical harmonics of degree l, mu = l (l + 1) / r^2.
void check_spherical_harmonics(double lambda)
{
  const double r = 1.5, t = 0.3;
  for(int l = 1; l <= 3; ++l)
  {
    const auto harmonic = [&](const K::Point_3& p) {
      const double x = p.x() / r, y = p.y() / r, z = p.z() / r;
      return l == 1 ? z : l == 2 ? x * y : z * (5 * z * z - 3);
    };
    const double mu = l * (l + 1) / (r * r), factor = (1 + lambda * t * mu) / (1 + t * mu);
    std::vector<double> errors;
    for(int level = 2; level <= 4; ++level)
    {
      const Mesh tm = built<Mesh>(icosphere(level, r));
      std::vector<double> f;
      for(Vertex v : vertices(tm))
        f.push_back(harmonic(tm.point(v)));
      std::vector<double> g(f.size());
      GDP_CHECK(GDP::process_signal(
                  tm, CGAL::make_property_map(f), CGAL::make_property_map(g),
                  GDP::parameters::gradient_weight(t).value_weight(1.).gradient_scale(lambda).area_normalization(false))
                == GDP::OK);
      double squares = 0, all = 0;
      for(std::size_t i = 0; i < f.size(); ++i)
      {
        squares += (g[i] - factor * f[i]) * (g[i] - factor * f[i]);
        all += factor * f[i] * factor * f[i];
      }
      errors.push_back(std::sqrt(squares / all));
    }
    check_second_order(errors, 1e-2);
  }
}

// The flat torus of the plane modulo the columns a and b of a matrix, whatever its points are: the metric says what it
// is. Plane waves are eigenfunctions, with mu = |k|^2 for the wave vector k.
struct Flat_torus
{
  Mesh tm;
  int m, n;
  std::array<double, 2> a, b; // the two periods
  Mesh::Property_map<Face, GDP::Triangle_metric> metrics;

  Flat_torus(int m, int n, const std::array<double, 2>& a, const std::array<double, 2>& b) : m(m), n(n), a(a), b(b)
  {
    build(torus(m, n), tm);
    metrics = tm.add_property_map<Face, GDP::Triangle_metric>("f:metric").first;
    for(Face f : faces(tm))
    {
      const auto h = tm.halfedge(f);
      const auto t1 = step(tm.source(h), tm.target(h)), t2 = step(tm.source(h), tm.target(tm.next(h)));
      metrics[f] = GDP::Triangle_metric(t1[0] * t1[0] + t1[1] * t1[1], t1[0] * t2[0] + t1[1] * t2[1],
                                        t2[0] * t2[0] + t2[1] * t2[1]);
    }
  }

  // from one vertex to a neighbor, in the plane
  std::array<double, 2> step(Vertex v, Vertex w) const
  {
    const auto wrapped = [](int d, int size) { return (d + size + 1) % size - 1; };
    const double i = wrapped(int(w) % m - int(v) % m, m) / double(m),
                 j = wrapped(int(w) / m - int(v) / m, n) / double(n);
    return {{i * a[0] + j * b[0], i * a[1] + j * b[1]}};
  }

  std::vector<double> wave(int p, int q) const
  {
    const double two_pi = 8 * std::atan(1.);
    std::vector<double> values;
    for(Vertex v : vertices(tm))
      values.push_back(std::cos(two_pi * (double(p * (int(v) % m)) / m + double(q * (int(v) / m)) / n) + 0.3));
    return values;
  }

  std::vector<double> filtered(std::vector<double> f, double t, double lambda) const
  {
    std::vector<double> g(f.size());
    GDP_CHECK(GDP::process_signal(tm, CGAL::make_property_map(f), CGAL::make_property_map(g),
      GDP::parameters::gradient_weight(t).value_weight(1.).gradient_scale(lambda).area_normalization(false)
        .face_metric_map(metrics)) == GDP::OK);
    return g;
  }
};

// On a regular grid a wave is an eigenvector of M and of S as well, whose eigenvalues follow from one row of each: to
// rounding.
void check_waves_on_a_grid(double lambda)
{
  const double two_pi = 8 * std::atan(1.), t = 0.05;
  const int m = 12, n = 10;
  const double width = 2, height = 3, hx = width / m, hy = height / n;
  const Flat_torus flat(m, n, {{width, 0}}, {{0, height}});
  for(int p = 0; p <= 3; ++p)
    for(int q = -2; q <= 2; ++q)
    {
      const double x = two_pi * p / m, y = two_pi * q / n;
      const double mass = hx * hy / 2 * (1 + (std::cos(x) + std::cos(y) + std::cos(x + y)) / 3);
      const double stiffness = hy / hx * 2 * (1 - std::cos(x)) + hx / hy * 2 * (1 - std::cos(y));
      const double factor = (mass + lambda * t * stiffness) / (mass + t * stiffness);
      const std::vector<double> f = flat.wave(p, q), g = flat.filtered(f, t, lambda);
      double worst = 0;
      for(std::size_t i = 0; i < f.size(); ++i)
        worst = (std::max)(worst, std::abs(g[i] - factor * f[i]));
      GDP_CHECK_NEAR(worst, 0, 1e-13);
    }
}

// Skew tori: the eigenvalues of the discrete operators tend to |k|^2.
void check_waves_in_the_limit(double lambda)
{
  const double two_pi = 8 * std::atan(1.), t = 0.05;
  const std::array<double, 2> a = {{2, 0.3}}, b = {{-0.7, 1.5}};
  const double det = a[0] * b[1] - a[1] * b[0];
  for(const std::array<int, 2>& pq : {std::array<int, 2>{{1, 0}}, {{0, 1}}, {{1, 1}}, {{1, -1}}})
  {
    // the wave vector has the products 2 pi p and 2 pi q with the periods
    const double kx = two_pi * (pq[0] * b[1] - pq[1] * a[1]) / det, ky = two_pi * (pq[1] * a[0] - pq[0] * b[0]) / det;
    const double mu = kx * kx + ky * ky, factor = (1 + lambda * t * mu) / (1 + t * mu);
    std::vector<double> errors;
    for(int size = 16; size <= 64; size *= 2)
    {
      const Flat_torus flat(size, size, a, b);
      const std::vector<double> f = flat.wave(pq[0], pq[1]), g = flat.filtered(f, t, lambda);
      double worst = 0;
      for(std::size_t i = 0; i < f.size(); ++i)
        worst = (std::max)(worst, std::abs(g[i] - factor * f[i]));
      errors.push_back(worst);
    }
    check_second_order(errors, 1e-2);
  }
}

} // namespace

int main()
{
  check_sphere();
  for(double lambda : {0., 0.5, 2.})
  {
    check_spherical_harmonics(lambda);
    check_waves_on_a_grid(lambda);
    check_waves_in_the_limit(lambda);
  }
  return GDP_TEST_RESULT();
}
