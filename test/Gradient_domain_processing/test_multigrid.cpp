// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The multigrid preconditioner: few iterations on every kind of mesh, slivers included, under every metric, and the
// same bits on any number of threads.

#include "test_meshes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/internal/linear_solver/multigrid/Conjugate_gradient.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

using namespace gdp_test;
namespace internal = CGAL::Gradient_domain_processing::internal;

typedef Eigen::SparseMatrix<double> Sparse;
typedef Eigen::Vector3d Vec;
typedef std::function<Vec(int, const Vec&)> Metric; // stretches the edges of a triangle

namespace {

Vec point(const Soup& soup, int v) { return Vec(soup.points[v][0], soup.points[v][1], soup.points[v][2]); }

// M + beta S, beta relative to the area of the embedding
Sparse system(const Soup& soup, double beta, const Metric& metric)
{
  double area = 0;
  for(const auto& t : soup.triangles)
    area += (point(soup, t[1]) - point(soup, t[0])).cross(point(soup, t[2]) - point(soup, t[0])).norm() / 2;
  std::vector<Eigen::Triplet<double> > entries;
  for(int f = 0; f < int(soup.triangles.size()); ++f)
  {
    const auto& t = soup.triangles[f];
    Vec e[3]; // opposite to the corners
    for(int i = 0; i < 3; ++i)
      e[i] = metric(f, point(soup, t[(i + 2) % 3]) - point(soup, t[(i + 1) % 3]));
    const double longest = (std::max)({e[0].squaredNorm(), e[1].squaredNorm(), e[2].squaredNorm()});
    const double doubled = (std::max)(e[0].cross(e[1]).norm(), 1.5e-8 * longest);
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        entries.emplace_back(t[i], t[j],
                             doubled / 24 * (i == j ? 2 : 1) + beta * area * e[i].dot(e[j]) / (2 * doubled));
  }
  Sparse a(int(soup.points.size()), int(soup.points.size()));
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

// Some triangles get a vertex: close to an edge, which makes a cap of them; close to a corner, which makes needles.
Soup with_slivers(Soup soup, int number, double height)
{
  Random random(13);
  for(int k = 0; k < number; ++k)
  {
    const std::size_t at = random.below(soup.triangles.size());
    const std::array<int, 3> t = soup.triangles[at];
    const double s = random(0.2, 0.8);
    const Vec a = point(soup, t[0]), b = point(soup, t[1]), c = point(soup, t[2]);
    const Vec p = k % 3 == 0 ? Vec(a + height * (s * (b - a) + (1 - s) * (c - a)))
                             : Vec((1 - height) * ((1 - s) * a + s * b) + height * c);
    const int v = int(soup.points.size());
    soup.points.push_back({{p.x(), p.y(), p.z()}});
    soup.triangles[at] = {{t[0], t[1], v}};
    soup.triangles.push_back({{t[1], t[2], v}});
    soup.triangles.push_back({{t[2], t[0], v}});
  }
  return soup;
}

Eigen::MatrixXd right_hand_side(const Soup& soup, const Sparse& a)
{
  Eigen::MatrixXd x(soup.points.size(), 3);
  Random random(5);
  for(int v = 0; v < int(x.rows()); ++v)
    x.row(v) = point(soup, v) + 0.01 * Vec(random(-1, 1), random(-1, 1), random(-1, 1));
  return a * x;
}

Vec embedding(int, const Vec& e) { return e; }

// Creases and flat places in turn: lengths across creases are up to thirty times as long.
Vec striped(int f, const Vec& e)
{
  const Vec d = Vec(1, 0.3, 0.2).normalized();
  return e + (f / 64 % 3 == 0 ? 29. : f / 64 % 3 == 1 ? 3. : 0.) * d.dot(e) * d;
}

Vec stretched(int, const Vec& e) { return Vec(8 * e.x(), e.y(), e.z()); }

// Returns the number of iterations.
int check(const std::string& name, const Soup& soup, double beta, const Metric& metric, int max_iterations)
{
  const Sparse a = system(soup, beta, metric);
  const Eigen::MatrixXd b = right_hand_side(soup, a);
  internal::Conjugate_gradient solver;
  Eigen::MatrixXd x;
  GDP_CHECK(solver.compute(a));
  GDP_CHECK(solver.solve(b, x));
  const Eigen::SimplicialLLT<Sparse> exact(a);
  const Eigen::MatrixXd y = exact.solve(b);
  const double error = (x - y).cwiseAbs().maxCoeff() / y.cwiseAbs().maxCoeff();
  std::cout << name << ", beta " << beta << ": " << a.rows() << " rows, " << solver.iterations
            << " iterations, at most " << max_iterations << "; against Cholesky " << error << std::endl;
  GDP_CHECK(error < 1e-6);
  GDP_CHECK(solver.iterations <= max_iterations);
  return solver.iterations;
}

void check_iterations()
{
  const Soup sphere = bumpy_sphere(5), patch = bumpy_patch(90, 110);
  check("sphere", sphere, 1e-4, embedding, 23);
  check("sphere", sphere, 1., embedding, 30);
  check("patch", patch, 1., embedding, 16);
  check("patch, striped", patch, 1., striped, 50);
  check("patch, stretched", patch, 1., stretched, 24);
}

void check_slivers()
{
  const Soup sphere = bumpy_sphere(4);
  for(double height : {1e-3, 1e-6, 1e-9})
  {
    const std::string of_height = " of height " + std::to_string(std::log10(height));
    check("slivers" + of_height, with_slivers(sphere, 150, height), 1., embedding, 23);
    check("slivers striped" + of_height, with_slivers(sphere, 150, height), 1., striped, 54);
    check("slivers stretched" + of_height, with_slivers(sphere, 150, height), 1., stretched, 46);
  }
}

void check_threads()
{
  const Soup soup = with_slivers(bumpy_sphere(5), 400, 1e-6);
  const Sparse a = system(soup, 1., striped);
  const Eigen::MatrixXd b = right_hand_side(soup, a);
  const auto solved = [&](bool parallel) {
    internal::Conjugate_gradient solver;
    solver.parallel = parallel;
    Eigen::MatrixXd x;
    GDP_CHECK(solver.compute(a) && solver.solve(b, x));
    return x;
  };
  const Eigen::MatrixXd sequential = solved(false);
  GDP_CHECK(sequential == solved(true));
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  GDP_CHECK(sequential == solved(true));
#endif
}

void check_cancelling()
{
  const Soup soup = bumpy_sphere(4);
  const Sparse a = system(soup, 1., embedding);
  const Eigen::MatrixXd b = right_hand_side(soup, a);
  internal::Conjugate_gradient solver;
  Eigen::MatrixXd x;
  int questions = 0;
  GDP_CHECK(solver.compute(a, [&] { return ++questions > 0; }));
  const int levels = questions;
  GDP_CHECK(levels > 1 && !solver.is_cancelled);
  GDP_CHECK(solver.solve(b, x, [&] { return ++questions > 0; }));
  GDP_CHECK(questions == levels + solver.iterations && !solver.is_cancelled);
  for(int last = 1; last <= solver.iterations; ++last)
  {
    internal::Conjugate_gradient again;
    GDP_CHECK(again.compute(a));
    questions = 0;
    GDP_CHECK(!again.solve(b, x, [&] { return ++questions < last; }));
    GDP_CHECK(questions == last && again.is_cancelled && again.iterations == last - 1);
  }
  for(int last = 1; last <= levels; ++last)
  {
    questions = 0;
    GDP_CHECK(!solver.compute(a, [&] { return ++questions < last; }));
    GDP_CHECK(questions == last && solver.is_cancelled);
  }
}

} // namespace

int main()
{
  check_iterations();
  check_slivers();
  check_threads();
  check_cancelling();
  return GDP_TEST_RESULT();
}
