// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Conjugate gradients agree with Cholesky, tell when they do not converge, and do not depend on the number of threads.

#include "test_meshes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/Conjugate_gradient_solver_traits.h>
#include <CGAL/Gradient_domain_processing/process_signal.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double> K;
typedef CGAL::Surface_mesh<K::Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef GDP::Conjugate_gradient_solver_traits<> Conjugate_gradient;
typedef GDP::Conjugate_gradient_solver_traits<CGAL::Sequential_tag> Sequential_conjugate_gradient;

namespace {

// Large enough for several levels of the multigrid and several blocks of rows.
const Soup& large_sphere()
{
  static const Soup soup = bumpy_sphere(6);
  return soup;
}

const Soup& large_patch()
{
  static const Soup soup = bumpy_patch(120, 170);
  return soup;
}

// Needles: lengths differ by a factor of a hundred.
Soup stretched_patch()
{
  return transformed(bumpy_patch(60, 60), [](const Coordinates& p) { return Coordinates{{100 * p[0], p[1], p[2]}}; });
}

template <class NamedParameters>
std::vector<Coordinates> smoothed(const Soup& soup, const NamedParameters& np)
{
  Mesh tm = built<Mesh>(soup);
  GDP_CHECK(GDP::smooth(tm, np) == GDP::OK);
  return coordinates(tm);
}

template <class NamedParameters>
void check_agreement(const Soup& soup, const NamedParameters& np)
{
  const Conjugate_gradient solver;
  const auto exact = smoothed(soup, np), found = smoothed(soup, np.sparse_linear_solver(solver));
  const double change = distance(exact, soup.points);
  GDP_CHECK(change > 0);
  GDP_CHECK_NEAR(distance(found, exact) / change, 0, 1e-8);
  GDP_CHECK(solver.error() <= 1e-10);
  GDP_CHECK(solver.iterations() > 0 && solver.iterations() < 100);
}

void check_agreement()
{
  for(const Soup* soup : {&large_sphere(), &large_patch()})
    for(double beta : {1e-8, 1e-4, 1e-2, 1.})
      check_agreement(*soup, GDP::parameters::gradient_weight(beta));
  check_agreement(stretched_patch(), GDP::parameters::gradient_weight(1e-2));
  check_agreement(icosphere(0), GDP::parameters::gradient_weight(1e-2));
  for(const auto kind : {GDP::Curvature_metric_kind::EDGE_AWARE, GDP::Curvature_metric_kind::ANISOTROPIC})
    check_agreement(jittered(box(40), 1e-3, 5),
                    GDP::parameters::gradient_weight(1e-2).curvature_weight(1.).curvature_metric_kind(kind));
}

// Without a value weight, all is held by a few vertices: the hardest system there is.
void check_constraints()
{
  Mesh tm = built<Mesh>(large_patch());
  auto constrained = tm.add_property_map<Vertex, bool>("v:constrained", false).first;
  auto in = tm.add_property_map<Vertex, double>("v:in", 0.).first;
  auto exact = tm.add_property_map<Vertex, double>("v:exact").first;
  auto found = tm.add_property_map<Vertex, double>("v:found").first;
  for(int v : {0, 7000, 20000})
  {
    constrained[Vertex(v)] = true;
    in[Vertex(v)] = v + 1;
  }
  const auto np = GDP::parameters::value_weight(0).gradient_weight(1).vertex_is_constrained_map(constrained);
  const Conjugate_gradient solver;
  GDP_CHECK(GDP::process_signal(tm, in, exact, np) == GDP::OK);
  GDP_CHECK(GDP::process_signal(tm, in, found, np.sparse_linear_solver(solver)) == GDP::OK);
  double difference = 0;
  for(Vertex v : vertices(tm))
    difference = (std::max)(difference, std::abs(found[v] - exact[v]));
  GDP_CHECK_NEAR(difference / 20001, 0, 1e-8);
}

// More channels than go through the matrix together, one of which need not change.
void check_many_channels()
{
  typedef std::array<double, 7> Signal;
  Mesh tm = built<Mesh>(large_sphere());
  auto in = tm.add_property_map<Vertex, Signal>("v:in").first;
  auto exact = tm.add_property_map<Vertex, Signal>("v:exact").first;
  auto found = tm.add_property_map<Vertex, Signal>("v:found").first;
  Random random(3);
  for(Vertex v : vertices(tm))
    for(int c = 0; c < 7; ++c)
      in[v][c] = c == 5 ? 3 : random(-1, 1);
  const auto np = GDP::parameters::gradient_weight(1e-3);
  GDP_CHECK(GDP::process_signal(tm, in, exact, np) == GDP::OK);
  GDP_CHECK(GDP::process_signal(tm, in, found, np.sparse_linear_solver(Conjugate_gradient())) == GDP::OK);
  double difference = 0;
  for(Vertex v : vertices(tm))
  {
    for(int c = 0; c < 7; ++c)
      difference = (std::max)(difference, std::abs(found[v][c] - exact[v][c]));
    GDP_CHECK(found[v][5] == 3);
  }
  GDP_CHECK_NEAR(difference, 0, 1e-8);
}

// What does not converge is solved by Cholesky.
void check_failure()
{
  const Conjugate_gradient hurried(1e-10, 2);
  const auto np = GDP::parameters::gradient_weight(1e-2);
  GDP_CHECK(smoothed(large_sphere(), np.sparse_linear_solver(hurried)) == smoothed(large_sphere(), np));
  GDP_CHECK(hurried.iterations() == 2);
  GDP_CHECK(hurried.error() > 1e-10 && hurried.error() < 1);

  // a looser tolerance takes less
  const Conjugate_gradient strict, loose(1e-4);
  smoothed(large_sphere(), GDP::parameters::gradient_weight(1e-2).sparse_linear_solver(strict));
  smoothed(large_sphere(), GDP::parameters::gradient_weight(1e-2).sparse_linear_solver(loose));
  GDP_CHECK(loose.error() <= 1e-4 && loose.iterations() < strict.iterations());
}

void check_determinism()
{
  const auto np = GDP::parameters::gradient_weight(1e-2);
  const auto sequential = smoothed(large_sphere(), np.concurrency_tag(CGAL::Sequential_tag())
                                                     .sparse_linear_solver(Sequential_conjugate_gradient()));
  const auto parallel = smoothed(large_sphere(), np.sparse_linear_solver(Conjugate_gradient()));
  GDP_CHECK(sequential == parallel);
}

// Any symmetric positive definite matrix, entry by entry: a path that is held at its ends by springs of stiffness one.
void check_traits()
{
  const int n = 1500;
  Conjugate_gradient::Matrix a(n);
  Conjugate_gradient::Vector b(n), x(n);
  for(int i = 0; i < n; ++i)
  {
    a.set_coef(i, i, 2, true);
    if(i > 0)
      a.set_coef(i, i - 1, -1, true);
    if(i + 1 < n)
      a.set_coef(i, i + 1, -1, true);
    b[i] = 1;
  }
  Conjugate_gradient solver;
  double d = 0;
  GDP_CHECK(solver.linear_solver(a, b, x, d));
  GDP_CHECK(d == 1);
  const auto exact = [&](int i) { return (i + 1.) * (n - i) / 2; };
  for(int i = 0; i < n; ++i)
    GDP_CHECK_NEAR(x[i] / exact(i), 1, 1e-8);

  // the factorization serves further right-hand sides, and zero is solved by zero
  for(int i = 0; i < n; ++i)
    b[i] = 0;
  GDP_CHECK(solver.linear_solver(b, x));
  GDP_CHECK(solver.iterations() == 0);
  for(int i = 0; i < n; ++i)
    GDP_CHECK(x[i] == 0);

  Conjugate_gradient::Matrix not_positive(2);
  not_positive.set_coef(0, 0, 1, true);
  not_positive.set_coef(1, 1, -1, true);
  GDP_CHECK(!solver.factor(not_positive, d));

  Conjugate_gradient::Matrix indefinite(2);
  for(int i = 0; i < 2; ++i)
    for(int j = 0; j < 2; ++j)
      indefinite.set_coef(i, j, i == j ? 1 : 2, true);
  Conjugate_gradient::Vector b2(2), x2(2);
  b2[0] = 1;
  b2[1] = -1;
  GDP_CHECK(!solver.factor(indefinite, d) || !solver.linear_solver(b2, x2)); // noticed at the latest as it solves
}

} // namespace

int main()
{
  check_agreement();
  check_constraints();
  check_many_channels();
  check_failure();
  check_determinism();
  check_traits();
  return GDP_TEST_RESULT();
}
