// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The second-order operators on arrays: bi-Laplacian, curved Hessian and its parts.

#include "test_arrays.h"

#include <CGAL/Gradient_domain_processing/internal/higher_order/bilaplacian.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/edge_neighbors.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/shared_lengths.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/hessian_energy.h>

#include <functional>
#include <string>
#include <vector>

using namespace gdp_test;
using namespace GDP::internal;

namespace {

const std::vector<GDP::Hessian_kind> kinds = {GDP::Hessian_kind::BILAPLACIAN, GDP::Hessian_kind::CURVED_HESSIAN,
                                              GDP::Hessian_kind::SQUARED_HESSIAN,
                                              GDP::Hessian_kind::TRACE_FREE_HESSIAN};

Sparse hessian(const Arrays& arrays, const Metrics& metrics, GDP::Hessian_kind kind, bool parallel = true)
{
  return hessian_energy(arrays, metrics, kind, parallel);
}

double lowest_eigenvalue(const Sparse& matrix)
{
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(matrix)).eigenvalues()[0];
}

// A grid in the plane with shifted vertices and a hole.
Arrays planar_mesh(int n)
{
  Random random(5);
  Soup soup = transformed(grid(n, n), [&](const Coordinates& p) {
    const double x = random(-0.2, 0.2), y = random(-0.2, 0.2);
    return Coordinates{{p[0] + x / n, p[1] + y / n, 0}};
  });
  soup.triangles.erase(soup.triangles.begin() + 2 * n + 5);
  return arrays_of(soup);
}

Metrics random_metrics(const Arrays& arrays, double largest_stretch)
{
  Random random(17);
  Metrics metrics;
  for(int f = 0; f < arrays.number_of_triangles(); ++f)
    metrics.given.push_back(arrays.embedding_metric(f).scaled(std::exp(random(0, std::log(largest_stretch)))));
  return metrics;
}

// Of libigl's curved_hessian_energy(): see data/curved_hessian_libigl.md.
void test_against_libigl()
{
  for(const std::string name : {"box", "patch", "components"})
  {
    const Arrays arrays = arrays_of(read_off(name));
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(arrays.number_of_vertices(), arrays.number_of_vertices());
    std::ifstream file("data/" + name + "_curved_hessian_libigl.txt");
    std::string comment;
    std::getline(file, comment);
    int i = 0, j = 0, entries = 0;
    for(double value; file >> i >> j >> value; ++entries)
      expected(i, j) = expected(j, i) = value;
    GDP_CHECK(entries > 400);
    const Eigen::MatrixXd found = hessian(arrays, Metrics(), GDP::Hessian_kind::CURVED_HESSIAN);
    GDP_CHECK_NEAR((found - expected).cwiseAbs().maxCoeff(), 0, 1e-10);
  }
}

void test_bilaplacian_is_the_product()
{
  const Arrays arrays = arrays_of(bumpy_patch(6, 5));
  const Metrics metrics = random_metrics(arrays, 3);
  const int n = arrays.number_of_vertices();
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(n);
  for(int f = 0; f < arrays.number_of_triangles(); ++f)
  {
    const auto& t = arrays.triangles[f];
    const GDP::Triangle_metric metric = metrics(arrays, f);
    Eigen::Matrix2d g;
    g << metric.g11(), metric.g12(), metric.g12(), metric.g22();
    Eigen::Matrix<double, 2, 3> differences;
    differences << -1, 1, 0, -1, 0, 1;
    const Eigen::Matrix3d element = metric.area() * differences.transpose() * g.inverse() * differences;
    for(int i = 0; i < 3; ++i)
    {
      mass[t[i]] += metric.area() / 3;
      for(int j = 0; j < 3; ++j)
        stiffness(t[i], t[j]) += element(i, j);
    }
  }
  const Eigen::MatrixXd expected = stiffness * mass.cwiseInverse().asDiagonal() * stiffness;
  const Eigen::MatrixXd found = bilaplacian(arrays, metrics, true);
  GDP_CHECK_NEAR((found - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff(), 0, 1e-13);
}

// Constants always, linear functions on a plane whatever its border: that is what the bi-Laplacian lacks.
void test_kernels()
{
  const Arrays plane = planar_mesh(7), patch = arrays_of(bumpy_patch(6, 5));
  const auto linear = [](const Vec& p) { return 2 * p.x() - 3 * p.y() + 1; };
  for(std::size_t i = 0; i < kinds.size(); ++i)
  {
    const Sparse on_plane = hessian(plane, Metrics(), kinds[i]),
                 on_patch = hessian(patch, random_metrics(patch, 50), kinds[i]);
    GDP_CHECK_NEAR((on_patch * Eigen::VectorXd::Ones(on_patch.rows())).cwiseAbs().maxCoeff() / largest(on_patch), 0,
                   1e-12);
    const double residual = (on_plane * sampled(plane, linear)).cwiseAbs().maxCoeff() / largest(on_plane);
    GDP_CHECK(i == 0 ? residual > 1e-3 : residual < 1e-12);
  }
}

// Energies of harmonics of degree l on a sphere, with mu = l (l + 1): mu^2, without the curvature's part mu less,
// without the trace half of mu^2 less again. That of the bi-Laplacian converges to second order, the others slower
// where the mesh changes its pattern.
void test_sphere()
{
  const auto degree_1 = [](const Vec& p) { return p.x() + 2 * p.y() - p.z(); };
  const auto degree_2 = [](const Vec& p) { return 3 * p.z() * p.z() - 1 + p.x() * p.y(); };
  const double expected[4][2] = {{4, 36}, {4, 36}, {2, 30}, {0, 12}};
  for(std::size_t i = 0; i < kinds.size(); ++i)
    for(int degree = 1; degree <= 2; ++degree)
    {
      double last = 0;
      for(int level = 3; level <= 4; ++level)
      {
        const Arrays sphere = arrays_of(icosphere(level));
        const Eigen::VectorXd u = degree == 1 ? sampled(sphere, degree_1) : sampled(sphere, degree_2);
        const std::vector<double> masses = lumped_masses(sphere, Metrics(), true);
        const double norm = u.cwiseAbs2().dot(Eigen::Map<const Eigen::VectorXd>(masses.data(), u.size()));
        const double error = energy(hessian(sphere, Metrics(), kinds[i]), u) / norm - expected[i][degree - 1];
        GDP_CHECK_NEAR(error, 0, (level == 3 ? 0.015 : 0.005) * (i == 3 ? 36 : expected[i][degree - 1]));
        if(i == 0 && level == 4)
          GDP_CHECK_NEAR(error / last, 0.25, 0.01);
        last = error;
      }
    }
}

// Semidefinite under metrics that jump by any factor; the curved one is not, where negative curvature meets a border.
void test_definiteness()
{
  const Arrays components = arrays_of(read_off("components")), patch = arrays_of(bumpy_patch(5, 6));
  for(double stretch : {1., 2., 1e4})
    for(const Arrays& arrays : {components, patch})
    {
      const Metrics metrics = random_metrics(arrays, stretch);
      for(GDP::Hessian_kind kind : {kinds[0], kinds[2], kinds[3]})
      {
        const Sparse matrix = hessian(arrays, metrics, kind);
        GDP_CHECK(lowest_eigenvalue(matrix) > -1e-12 * largest(matrix));
        GDP_CHECK(largest(Sparse(matrix - Sparse(matrix.transpose()))) == 0);
      }
    }
  GDP_CHECK(lowest_eigenvalue(hessian(components, Metrics(), GDP::Hessian_kind::CURVED_HESSIAN)) < -1e-4);
}

Vec map_of_plane(const Vec& p)
{
  return Vec(p.x() + 0.3 * p.x() * p.x() - 0.2 * p.y() * p.y(), p.y() + 0.3 * p.x() * p.y() + 0.2 * p.y() * p.y(), 0);
}

Eigen::Matrix2d metric_of_map(const Vec& p)
{
  Eigen::Matrix2d jacobian;
  jacobian << 1 + 0.6 * p.x(), -0.4 * p.y(), 0.3 * p.y(), 1 + 0.3 * p.x() + 0.4 * p.y();
  return jacobian.transpose() * jacobian;
}

// The metric that a map of the plane induces is flat, and the coordinates of the map are linear in it: their energy
// goes to zero, that of the square of one to four times the area. The lengths of an edge under its two metrics differ;
// if every triangle keeps its own, the energy of the coordinates stays where it is, at 0.11.
void test_edges_with_two_lengths()
{
  double last = 0;
  for(int n : {16, 32, 64})
  {
    const Arrays arrays = arrays_of(grid(n, n));
    const Sparse matrix = hessian(arrays, planar_metrics(arrays, metric_of_map), GDP::Hessian_kind::SQUARED_HESSIAN);
    const double of_linear = energy(matrix, sampled(arrays, [](const Vec& p) { return map_of_plane(p).x(); }));
    const double of_square =
      energy(matrix, sampled(arrays, [](const Vec& p) { return std::pow(map_of_plane(p).x(), 2); }));
    Arrays image = arrays;
    for(Vec& p : image.points)
      p = map_of_plane(p);
    GDP_CHECK(of_linear > 0 && of_linear < 0.1 / n);
    GDP_CHECK(last == 0 || of_linear < 0.55 * last);
    GDP_CHECK_NEAR(of_square / (4 * image.area(true)), 1, 1. / n);
    last = of_linear;
  }
}

void test_shared_lengths()
{
  const Arrays arrays = arrays_of(bumpy_patch(6, 5));
  const std::vector<int> neighbors = edge_neighbors(arrays, true);
  const auto equal = [](const GDP::Triangle_metric& a, const GDP::Triangle_metric& b) {
    return a.g11() == b.g11() && a.g12() == b.g12() && a.g22() == b.g22()
           && a.sqrt_determinant() == b.sqrt_determinant();
  };
  const std::vector<GDP::Triangle_metric> embedded = with_shared_lengths(arrays, Metrics(), neighbors, true);
  const Metrics near = random_metrics(arrays, 1.2), far = random_metrics(arrays, 1e6);
  const auto near_shared = with_shared_lengths(arrays, near, neighbors, true),
             far_shared = with_shared_lengths(arrays, far, neighbors, true);
  double nearest = HUGE_VAL;
  for(int corner = 0; corner < int(neighbors.size()); ++corner)
  {
    const int f = corner / 3, across = neighbors[corner];
    GDP_CHECK(equal(embedded[f], arrays.embedding_metric(f)));
    const double kept = far_shared[f].area() / far(arrays, f).area();
    GDP_CHECK(far_shared[f].is_valid() && kept > 0.5 - 1e-9);
    nearest = (std::min)(nearest, kept);
    const double own = squared_length(near(arrays, f), corner % 3);
    const double expected = across < 0 ? own : (own + squared_length(near(arrays, across / 3), across % 3)) / 2;
    GDP_CHECK_NEAR(squared_length(near_shared[f], corner % 3) / expected, 1, 1e-12);
  }
  GDP_CHECK_NEAR(nearest, 0.5, 1e-6);
}

// The orientation of the triangles does not matter, nor at which vertex they begin; scaling by s divides by s^2.
void test_invariance()
{
  const Soup soup = bumpy_patch(6, 5);
  Soup turned = soup;
  Random random(3);
  for(auto& t : turned.triangles)
  {
    if(random(0, 1) < 0.5)
      std::swap(t[0], t[1]);
    if(random(0, 1) < 0.5)
      t = {{t[1], t[2], t[0]}};
  }
  for(GDP::Hessian_kind kind : kinds)
  {
    const Sparse matrix = hessian(arrays_of(soup), Metrics(), kind),
                 of_turned = hessian(arrays_of(turned), Metrics(), kind),
                 of_scaled = hessian(arrays_of(scaled(soup, 10)), Metrics(), kind);
    GDP_CHECK_NEAR(largest(Sparse(matrix - of_turned)) / largest(matrix), 0, 1e-12);
    GDP_CHECK_NEAR(largest(Sparse(matrix - 100 * of_scaled)) / largest(matrix), 0, 1e-12);
  }
}

// Where three triangles meet, each has a border of its own: a function that is linear on each of three half planes
// costs nothing.
void test_three_triangles_at_an_edge()
{
  Soup book = grid(4, 4);
  const Soup page = book;
  const int n = int(page.points.size());
  for(int k = 1; k <= 2; ++k) // two more pages, turned about the side x = 0
  {
    std::vector<int> place;
    for(int v = 0; v < n; ++v)
    {
      const Coordinates& p = page.points[v];
      const bool is_on_spine = p[0] == 0;
      place.push_back(is_on_spine ? v : int(book.points.size()));
      if(!is_on_spine)
        book.points.push_back({{p[0] * std::cos(2. * k), p[1], p[0] * std::sin(2. * k)}});
    }
    for(const auto& t : page.triangles)
      book.triangles.push_back({{place[t[0]], place[t[1]], place[t[2]]}});
  }
  const Arrays arrays = arrays_of(book);
  Eigen::VectorXd values = sampled(arrays, [](const Vec& p) { return p.y(); });
  for(int v = 0; v < arrays.number_of_vertices(); ++v)
    values[v] += (v < n ? 1 : -3) * arrays.points[v].x();
  for(GDP::Hessian_kind kind : {kinds[1], kinds[2], kinds[3]})
  {
    const Sparse matrix = hessian(arrays, Metrics(), kind);
    GDP_CHECK_NEAR((matrix * values).cwiseAbs().maxCoeff() / largest(matrix), 0, 1e-12);
  }
}

// Triangles without area, points that coincide, vertices without a triangle, a triangle that is there twice.
void test_degenerate()
{
  Soup soup = bumpy_patch(6, 5);
  soup.points[8] = soup.points[9];
  soup.points[17] = soup.points[16];
  for(int i = 0; i < 3; ++i)
    soup.points[24][i] = (soup.points[23][i] + soup.points[25][i]) / 2;
  soup.points.push_back({{1, 2, 3}});
  soup.triangles.push_back(soup.triangles[10]);
  const int n = int(soup.points.size());
  soup.points.insert(soup.points.end(), 3, Coordinates{{1, 1, 1}});
  soup.triangles.push_back({{n, n + 1, n + 2}});
  const Arrays arrays = arrays_of(soup);
  for(GDP::Hessian_kind kind : kinds)
  {
    const Sparse matrix = hessian(arrays, Metrics(), kind);
    GDP_CHECK(std::isfinite(largest(matrix)));
    GDP_CHECK(Sparse(matrix.middleCols(n - 1, 4)).norm() == 0);
    GDP_CHECK_NEAR((matrix * Eigen::VectorXd::Ones(matrix.rows())).cwiseAbs().maxCoeff() / largest(matrix), 0, 1e-10);
  }
}

void test_threads()
{
  const Arrays arrays = arrays_of(bumpy_sphere(5));
  const auto same = [](const Sparse& a, const Sparse& b) {
    return a.nonZeros() == b.nonZeros()
           && std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr())
           && std::equal(a.valuePtr(), a.valuePtr() + a.nonZeros(), b.valuePtr());
  };
  GDP_CHECK(same(bilaplacian(arrays, Metrics(), true), bilaplacian(arrays, Metrics(), false)));
  GDP_CHECK(same(hessian(arrays, Metrics(), GDP::Hessian_kind::CURVED_HESSIAN),
                 hessian(arrays, Metrics(), GDP::Hessian_kind::CURVED_HESSIAN, false)));
}

} // namespace

int main()
{
  test_against_libigl();
  test_bilaplacian_is_the_product();
  test_kernels();
  test_sphere();
  test_definiteness();
  test_edges_with_two_lengths();
  test_shared_lengths();
  test_invariance();
  test_three_triangles_at_an_edge();
  test_degenerate();
  test_threads();
  return GDP_TEST_RESULT();
}
