// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Patches that minimize an energy of second order, on arrays.

#include "test_arrays.h"

#include <CGAL/Gradient_domain_processing/internal/higher_order/constrained_minimum.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/edge_neighbors.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/fair_patch.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/hessian_energy.h>

#include <algorithm>
#include <cstring>
#include <vector>

using namespace gdp_test;
using namespace GDP::internal;

namespace {

const std::vector<GDP::Hessian_kind> kinds = {GDP::Hessian_kind::BILAPLACIAN, GDP::Hessian_kind::CURVED_HESSIAN,
                                              GDP::Hessian_kind::SQUARED_HESSIAN,
                                              GDP::Hessian_kind::TRACE_FREE_HESSIAN};

bool same_bits(const Vec& a, const Vec& b) { return std::memcmp(a.data(), b.data(), sizeof(Vec)) == 0; }

struct Cap
{
  Arrays arrays;
  std::vector<char> is_free;
  double top = 0, distance = 0; // from the sphere
};

// The cap of a unit sphere above a height is cut off flat, and then made fair.
Cap fair_cap(int level, double height, GDP::Hessian_kind kind, int iterations)
{
  Cap cap;
  cap.arrays = arrays_of(icosphere(level));
  for(Vec& p : cap.arrays.points)
  {
    cap.is_free.push_back(p.z() > height);
    if(p.z() > height)
      p.z() = height;
  }
  const Arrays flat = cap.arrays;
  GDP_CHECK(fair_patch(cap.arrays, cap.is_free, kind, iterations, 1e-4, true) == GDP::ok);
  for(std::size_t v = 0; v < cap.is_free.size(); ++v)
  {
    GDP_CHECK(cap.is_free[v] || same_bits(cap.arrays.points[v], flat.points[v]));
    cap.top = (std::max)(cap.top, cap.arrays.points[v].z());
    cap.distance = (std::max)(cap.distance, std::abs(cap.arrays.points[v].norm() - 1));
  }
  return cap;
}

// A membrane stays at 0.793, one linear bi-Laplacian gives 0.973, and only the trace-free energy has the sphere as its
// end.
void test_sphere()
{
  GDP_CHECK_NEAR(fair_cap(4, 0.793, GDP::Hessian_kind::BILAPLACIAN, 1).top, 0.973, 0.001);
  GDP_CHECK_NEAR(fair_cap(4, 0.793, GDP::Hessian_kind::BILAPLACIAN, 10).top, 0.9837, 0.001);
  GDP_CHECK_NEAR(fair_cap(4, 0.793, GDP::Hessian_kind::SQUARED_HESSIAN, 10).top, 0.992, 0.001);
  const Cap coarse = fair_cap(3, 0.793, GDP::Hessian_kind::TRACE_FREE_HESSIAN, 10),
            fine = fair_cap(4, 0.793, GDP::Hessian_kind::TRACE_FREE_HESSIAN, 10);
  GDP_CHECK_NEAR(coarse.top, 1, 0.002);
  GDP_CHECK_NEAR(fine.top, 1, 0.0005);
  GDP_CHECK(fine.distance < 0.0005);
  GDP_CHECK_NEAR(fair_cap(4, 0.4, GDP::Hessian_kind::TRACE_FREE_HESSIAN, 10).top, 1, 0.01); // most of a half
}

// The angle between the normals on both sides of the border halves with the edges: no crease.
void test_smooth_at_the_border()
{
  double last = 0;
  for(int level : {3, 4})
  {
    const Cap cap = fair_cap(level, 0.6, GDP::Hessian_kind::TRACE_FREE_HESSIAN, 10);
    double sharpest = 0;
    const std::vector<int> neighbors = edge_neighbors(cap.arrays, true);
    const auto normal = [&](int f) {
      const auto& t = cap.arrays.triangles[f];
      const Vec& p = cap.arrays.points[t[0]];
      return Vec((cap.arrays.points[t[1]] - p).cross(cap.arrays.points[t[2]] - p).normalized());
    };
    for(std::size_t corner = 0; corner < neighbors.size(); ++corner)
      sharpest = (std::max)(sharpest, normal(int(corner) / 3).cross(normal(neighbors[corner] / 3)).norm());
    GDP_CHECK(last == 0 || sharpest < 0.6 * last);
    last = sharpest;
  }
}

// On a plane: linear functions exactly, with any border; quadratic ones, of which all energies have the biharmonic as
// minimizers, to second order.
void test_polynomials()
{
  const auto linear = [](const Vec& p) { return 3 * p.x() - p.y() + 2; };
  const auto quadratic = [](const Vec& p) { return 2 * p.x() * p.x() + p.x() * p.y() - 0.5 * p.y() * p.y(); };
  for(GDP::Hessian_kind kind : kinds)
  {
    double last = 0;
    for(int n : {16, 32, 64})
    {
      const Arrays plane = arrays_of(transformed(grid(n, n), [](const Coordinates& p) {
        return Coordinates{{p[0] + 0.1 * std::sin(4 * p[1]), p[1] + 0.1 * p[0] * p[0], 0}};
      }));
      std::vector<char> is_free;
      for(int v = 0; v < plane.number_of_vertices(); ++v)
      {
        const int i = v % (n + 1), j = v / (n + 1);
        is_free.push_back(i >= n / 4 && i <= 3 * n / 4 && j >= n / 4 && j <= 3 * n / 4 && (i < n / 2 || j > 3 * n / 8));
      }
      const Sparse energy = hessian_energy(plane, Metrics(), kind, true);
      Eigen::MatrixXd expected(plane.number_of_vertices(), 2);
      expected.col(0) = sampled(plane, linear);
      expected.col(1) = sampled(plane, quadratic);
      Eigen::MatrixXd found = expected;
      for(std::size_t v = 0; v < is_free.size(); ++v)
        if(is_free[v])
          found.row(Eigen::Index(v)) << 5, -5;
      GDP_CHECK(constrained_minimum(energy, is_free, found) == GDP::ok);
      GDP_CHECK_NEAR((found - expected).col(0).cwiseAbs().maxCoeff(), 0, 1e-9);
      const double error = (found - expected).col(1).cwiseAbs().maxCoeff();
      GDP_CHECK_NEAR(error, 0, 1e-5);
      GDP_CHECK(last == 0 || error < 0.26 * last);
      last = error;
    }
  }
}

// A flat patch in a flat surface moves by rounding only, one that nothing holds is an error, and what is not free stays
// to the bit.
void test_constraints()
{
  const Arrays plane = arrays_of(grid(12, 12));
  std::vector<char> is_free(plane.points.size(), 0);
  for(std::size_t v = 0; v < is_free.size(); ++v)
    is_free[v] = plane.points[v].x() > 0.5;
  Arrays flat = plane, bent = plane;
  GDP_CHECK(fair_patch(flat, is_free, GDP::Hessian_kind::TRACE_FREE_HESSIAN, 5, 1e-4, true) == GDP::ok);
  for(std::size_t v = 0; v < is_free.size(); ++v)
    GDP_CHECK_NEAR((flat.points[v] - plane.points[v]).norm(), 0, 1e-12);

  const std::vector<char> all(plane.points.size(), 1), none(plane.points.size(), 0);
  bent.points[87].z() = 0.3;
  const Arrays before = bent;
  GDP_CHECK(fair_patch(bent, all, GDP::Hessian_kind::TRACE_FREE_HESSIAN, 5, 1e-4, true) == GDP::error_unconstrained);
  GDP_CHECK(fair_patch(bent, none, GDP::Hessian_kind::TRACE_FREE_HESSIAN, 5, 1e-4, true) == GDP::ok);
  GDP_CHECK(fair_patch(bent, is_free, GDP::Hessian_kind::TRACE_FREE_HESSIAN, 0, 1e-4, true) == GDP::ok);
  for(std::size_t v = 0; v < is_free.size(); ++v)
    GDP_CHECK(same_bits(bent.points[v], before.points[v]));

  // a constrained vertex amid the patch is passed through
  is_free[87] = 0;
  GDP_CHECK(fair_patch(bent, is_free, GDP::Hessian_kind::SQUARED_HESSIAN, 3, 1e-4, true) == GDP::ok);
  double highest = 0;
  for(std::size_t v = 0; v < is_free.size(); ++v)
    if(is_free[v])
      highest = (std::max)(highest, bent.points[v].z());
  GDP_CHECK(same_bits(bent.points[87], before.points[87]) && highest > 0.1 && highest < 0.6);

  // three vertices hold a plane, two of them do not
  std::vector<char> few = all;
  few[0] = few[12] = 0;
  Arrays held = plane;
  GDP_CHECK(fair_patch(held, few, GDP::Hessian_kind::SQUARED_HESSIAN, 3, 1e-4, true) == GDP::error_unconstrained);
  few[160] = 0;
  GDP_CHECK(fair_patch(held, few, GDP::Hessian_kind::SQUARED_HESSIAN, 3, 1e-4, true) == GDP::ok);
  for(std::size_t v = 0; v < few.size(); ++v)
    GDP_CHECK_NEAR((held.points[v] - plane.points[v]).norm(), 0, 1e-9);
}

// The patch and its surroundings alone count, wherever the rest of the mesh is.
void test_patch_is_local()
{
  Soup soup = bumpy_sphere(3);
  std::vector<char> is_free;
  for(const Coordinates& p : soup.points)
    is_free.push_back(p[2] > 0.6);
  const auto run = [&](const Arrays& arrays) {
    Arrays result = arrays;
    GDP_CHECK(fair_patch(result, is_free, GDP::Hessian_kind::CURVED_HESSIAN, 2, 1e-4, true) == GDP::ok);
    return result;
  };
  const Arrays arrays = arrays_of(soup);
  Arrays whole = arrays;
  Eigen::MatrixXd x(whole.number_of_vertices(), 3);
  for(int iteration = 0; iteration < 2; ++iteration)
  {
    for(int v = 0; v < whole.number_of_vertices(); ++v)
      x.row(v) = whole.points[v].transpose();
    GDP_CHECK(constrained_minimum(hessian_energy(whole, Metrics(), GDP::Hessian_kind::CURVED_HESSIAN, true), is_free, x)
              == GDP::ok);
    for(int v = 0; v < whole.number_of_vertices(); ++v)
      whole.points[v] = x.row(v).transpose();
  }
  const Arrays patch = run(arrays);
  for(int v = 0; v < whole.number_of_vertices(); ++v)
    GDP_CHECK_NEAR((patch.points[v] - whole.points[v]).norm(), 0, 1e-12);
}

void test_degenerate()
{
  Soup soup = bumpy_sphere(3);
  std::vector<char> is_free;
  for(const Coordinates& p : soup.points)
    is_free.push_back(p[2] > 0.4);
  soup.points.push_back({{1, 2, 3}});
  is_free.push_back(1);
  const auto& t = soup.triangles[3], u = soup.triangles[17];
  soup.points[t[0]] = soup.points[t[1]];
  soup.points[u[0]] = soup.points[u[1]];
  Arrays arrays = arrays_of(soup);
  for(std::size_t v = 0; v < is_free.size(); ++v)
    if(is_free[v] && v % 3 == 0 && v + 1 < is_free.size())
      arrays.points[v] = Vec(0.1, 0.2, 0.3); // a third of the patch in one point
  GDP_CHECK(fair_patch(arrays, is_free, GDP::Hessian_kind::TRACE_FREE_HESSIAN, 10, 1e-4, true) == GDP::ok);
  GDP_CHECK(arrays.points.back() == Vec(1, 2, 3));
  for(const Vec& p : arrays.points)
    GDP_CHECK(p.allFinite() && p.norm() < 5);
}

} // namespace

int main()
{
  test_constraints();
  test_patch_is_local();
  test_degenerate();
  test_sphere();
  test_smooth_at_the_border();
  test_polynomials();
  return GDP_TEST_RESULT();
}
