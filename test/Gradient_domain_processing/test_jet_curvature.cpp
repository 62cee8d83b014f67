// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The curvature estimators on arrays, against the curvatures of surfaces that are known exactly.

#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/internal/curvature/face_curvature.h>
#include <CGAL/Gradient_domain_processing/internal/curvature/jet_curvature.h>
#include <CGAL/Gradient_domain_processing/internal/curvature/normal_curvature.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace GDPI = CGAL::Gradient_domain_processing::internal;
using GDPI::Principal_curvatures;
using GDPI::Vec3;
typedef Eigen::Matrix3d Mat3;
typedef std::array<int, 3> Triangle;

struct Random
{
  std::mt19937 engine;
  // in [-1, 1), the same with every standard library
  double operator()() { return engine() / 2147483648. - 1.; }
};

struct Arrays
{
  std::vector<Vec3> points, normals;
  std::vector<Triangle> triangles;
  std::vector<int> offsets, neighbors;

  void connect()
  {
    std::vector<std::set<int> > rings(points.size());
    for(const Triangle& t : triangles)
      for(int i = 0; i < 3; ++i)
        for(int j = 0; j < 3; ++j)
          if(i != j)
            rings[t[i]].insert(t[j]);
    offsets.assign(1, 0);
    neighbors.clear();
    for(const std::set<int>& ring : rings)
    {
      neighbors.insert(neighbors.end(), ring.begin(), ring.end());
      offsets.push_back(static_cast<int>(neighbors.size()));
    }
  }
};

// ---- surfaces F = 0, F growing outwards: the derivative of the unit normal is the exact curvature tensor

struct Surface
{
  std::string name;
  std::function<Vec3(const Vec3&)> gradient;
  std::function<Mat3(const Vec3&)> hessian;
  std::function<Arrays(int)> mesh;                 // points only and triangles
  std::function<bool(const Vec3&)> is_inside;      // far from a border

  Vec3 normal(const Vec3& p) const { return gradient(p).normalized(); }
  Mat3 tensor(const Vec3& p) const
  {
    const Vec3 n = normal(p);
    const Mat3 projector = Mat3::Identity() - n * n.transpose();
    return projector * hessian(p) * projector / gradient(p).norm();
  }
  // exact principal curvatures: the eigenvalues of tangent eigenvectors
  Principal_curvatures curvatures(const Vec3& p) const
  {
    const Vec3 n = normal(p);
    const double big = 1e6;
    const Eigen::SelfAdjointEigenSolver<Mat3> eigen(tensor(p) + big * n * n.transpose());
    return { eigen.eigenvalues()[0], eigen.eigenvalues()[1], eigen.eigenvectors().col(0), eigen.eigenvectors().col(1) };
  }
};

// An octahedron, subdivided, jittered, and mapped to the ellipsoid.
Arrays ellipsoid_mesh(int n, const Vec3& axes)
{
  Arrays a;
  Random random;
  std::map<std::array<int, 3>, int> index;
  const auto vertex = [&](int x, int y, int z)
  {
    const auto found = index.insert({ {{ x, y, z }}, int(a.points.size()) });
    if(found.second)
    {
      const Vec3 p =
        Vec3(std::sin(x * 1.5707963 / n), std::sin(y * 1.5707963 / n), std::sin(z * 1.5707963 / n)).normalized();
      const double amount = 0.3 / n;
      const Vec3 q = (p + amount * Vec3(random(), random(), random())).normalized();
      a.points.push_back(axes.cwiseProduct(q));
    }
    return found.first->second;
  };
  for(int sx : { -1, 1 })
    for(int sy : { -1, 1 })
      for(int sz : { -1, 1 })
        for(int i = 0; i < n; ++i)
          for(int j = 0; j + i < n; ++j)
          {
            const auto at = [&](int u, int v) { return vertex(sx * u, sy * v, sz * (n - u - v)); };
            Triangle t = {{ at(i, j), at(i + 1, j), at(i, j + 1) }};
            if(sx * sy * sz < 0) std::swap(t[1], t[2]);
            a.triangles.push_back(t);
            if(i + j + 1 < n)
            {
              t = {{ at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) }};
              if(sx * sy * sz < 0) std::swap(t[1], t[2]);
              a.triangles.push_back(t);
            }
          }
  return a;
}

// A grid of parameters in [0, 1) x [0, 1), jittered, its diagonals chosen by chance; closed in u, v or not at all.
Arrays grid_mesh(int nu, int nv, bool u_is_closed, bool v_is_closed,
                 const std::function<Vec3(double, double)>& position)
{
  Arrays a;
  Random random;
  const int rows = nu + !u_is_closed, columns = nv + !v_is_closed;
  for(int i = 0; i < rows; ++i)
    for(int j = 0; j < columns; ++j)
    {
      const double u = i + 0.3 * random(), v = j + 0.3 * random();
      a.points.push_back(position(u / nu, v / nv));
    }
  for(int i = 0; i < nu; ++i)
    for(int j = 0; j < nv; ++j)
    {
      const auto at = [&](int s, int t) { return (s % rows) * columns + t % columns; };
      const int p = at(i, j), q = at(i + 1, j), r = at(i + 1, j + 1), s = at(i, j + 1);
      if(random() < 0)
      {
        a.triangles.push_back({{ p, q, r }});
        a.triangles.push_back({{ p, r, s }});
      }
      else
      {
        a.triangles.push_back({{ p, q, s }});
        a.triangles.push_back({{ q, r, s }});
      }
    }
  return a;
}

const double two_pi = 6.283185307179586;

Surface ellipsoid(const std::string& name, const Vec3& axes)
{
  const Vec3 w = axes.cwiseProduct(axes).cwiseInverse();
  return { name,
           [=](const Vec3& p) { return Vec3(2 * w.cwiseProduct(p)); },
           [=](const Vec3&) { return Mat3(2 * Mat3(w.asDiagonal())); },
           [=](int n) { return ellipsoid_mesh(n, axes); },
           [](const Vec3&) { return true; } };
}

Surface cylinder()
{
  return { "cylinder",
           [](const Vec3& p) { return Vec3(2 * p.x(), 2 * p.y(), 0); },
           [](const Vec3&) { return Mat3(Vec3(2, 2, 0).asDiagonal()); },
           [](int n) { return grid_mesh(4 * n, n, true, false, [](double u, double v) {
             return Vec3(std::cos(two_pi * u), std::sin(two_pi * u), 1.5 * v); }); },
           [](const Vec3& p) { return p.z() > 0.4 && p.z() < 1.1; } };
}

Surface torus()
{
  // (|(x, y)| - 1)^2 + z^2 = 0.4^2
  return { "torus",
           [](const Vec3& p) {
             const double rho = std::hypot(p.x(), p.y()), s = 2 * (rho - 1) / rho;
             return Vec3(s * p.x(), s * p.y(), 2 * p.z()); },
           [](const Vec3& p) {
             const double rho = std::hypot(p.x(), p.y()), s = 2 * (rho - 1) / rho, ds = 2 / (rho * rho * rho);
             Mat3 h = Mat3::Zero();
             h(0, 0) = s + ds * p.x() * p.x();
             h(0, 1) = h(1, 0) = ds * p.x() * p.y();
             h(1, 1) = s + ds * p.y() * p.y();
             h(2, 2) = 2;
             return h; },
           [](int n) { return grid_mesh(5 * n, 2 * n, true, true, [](double u, double v) {
             const double rho = 1 + 0.4 * std::cos(two_pi * v);
             return Vec3(rho * std::cos(two_pi * u), rho * std::sin(two_pi * u), 0.4 * std::sin(two_pi * v)); }); },
           [](const Vec3&) { return true; } };
}

Surface graph(const std::string& name, const std::function<double(double, double)>& height,
              const std::function<std::array<double, 5>(double, double)>& derivatives) // x, y, xx, xy, yy
{
  return { name,
           [=](const Vec3& p) { const auto d = derivatives(p.x(), p.y()); return Vec3(-d[0], -d[1], 1); },
           [=](const Vec3& p) {
             const auto d = derivatives(p.x(), p.y());
             Mat3 h = Mat3::Zero();
             h(0, 0) = -d[2]; h(0, 1) = h(1, 0) = -d[3]; h(1, 1) = -d[4];
             return h; },
           [=](int n) { return grid_mesh(2 * n, 2 * n, false, false, [=](double u, double v) {
             const double x = 2 * u - 1, y = 2 * v - 1;
             return Vec3(x, y, height(x, y)); }); },
           [](const Vec3& p) { return std::abs(p.x()) < 0.6 && std::abs(p.y()) < 0.6; } };
}

std::vector<Surface> surfaces()
{
  return {ellipsoid("sphere", Vec3(1, 1, 1)),
          ellipsoid("ellipsoid", Vec3(1, 1.3, 0.8)),
          cylinder(),
          torus(),
          graph(
            "saddle", [](double x, double y) { return (x * x - y * y) / 2 + x * y / 4; },
            [](double x, double y) {
              return std::array<double, 5>{{x + y / 4, -y + x / 4, 1, 0.25, -1}};
            }),
          graph(
            "monkey saddle", [](double x, double y) { return (x * x * x - 3 * x * y * y) / 3; },
            [](double x, double y) {
              return std::array<double, 5>{{x * x - y * y, -2 * x * y, 2 * x, -2 * y, -2 * x}};
            })};
}

Arrays sampled(const Surface& surface, int n)
{
  Arrays a = surface.mesh(n);
  for(const Vec3& p : a.points)
    a.normals.push_back(surface.normal(p));
  a.connect();
  return a;
}

template <class Tag = CGAL::Sequential_tag>
std::vector<Principal_curvatures> by_jets(const Arrays& a, int degree)
{
  std::vector<Principal_curvatures> result;
  GDP_CHECK(GDPI::jet_curvatures(
    std::is_same<Tag, CGAL::Parallel_tag>::value, a.points, a.offsets, a.neighbors, a.normals, degree,
    [](double) { return true; }, result));
  GDP_CHECK(result.size() == a.points.size());
  return result;
}

bool is_finite(const Principal_curvatures& c)
{
  return std::isfinite(c.min_curvature) && std::isfinite(c.max_curvature) && c.min_curvature <= c.max_curvature;
}

bool has_orthonormal_directions(const Principal_curvatures& c)
{
  return std::abs(c.min_direction.norm() - 1) < 1e-12 && std::abs(c.max_direction.norm() - 1) < 1e-12 &&
         std::abs(c.min_direction.dot(c.max_direction)) < 1e-12;
}

bool is_sound(const Principal_curvatures& c) { return is_finite(c) && has_orthonormal_directions(c); }

bool is_flat(const Principal_curvatures& c) { return is_sound(c) && c.min_curvature == 0 && c.max_curvature == 0; }

Mat3 tensor(const Principal_curvatures& c)
{
  return c.min_curvature * c.min_direction * c.min_direction.transpose() +
         c.max_curvature * c.max_direction * c.max_direction.transpose();
}

bool is_same(const Principal_curvatures& a, const Principal_curvatures& b)
{
  return a.min_curvature == b.min_curvature && a.max_curvature == b.max_curvature &&
         a.min_direction == b.min_direction && a.max_direction == b.max_direction;
}

struct Errors
{
  double curvature = 0, tensor = 0, worst = 0; // root mean squares of curvatures and tensors, worst of curvatures
};

Errors errors(const Surface& surface, const std::vector<Vec3>& where, const std::vector<Principal_curvatures>& computed)
{
  Errors e;
  int count = 0;
  for(std::size_t i = 0; i < where.size(); ++i)
  {
    GDP_CHECK(is_sound(computed[i]));
    if(!surface.is_inside(where[i]))
      continue;
    ++count;
    const Principal_curvatures exact = surface.curvatures(where[i]);
    const double d1 = computed[i].min_curvature - exact.min_curvature,
                 d2 = computed[i].max_curvature - exact.max_curvature;
    e.curvature += d1 * d1 + d2 * d2;
    e.tensor += (tensor(computed[i]) - surface.tensor(where[i])).squaredNorm();
    e.worst = (std::max)({ e.worst, std::abs(d1), std::abs(d2) });
  }
  GDP_CHECK(count > 10);
  e.curvature = std::sqrt(e.curvature / (2 * count));
  e.tensor = std::sqrt(e.tensor / count);
  return e;
}

// ---- the tests

void test_convergence_of_jets()
{
  const int resolutions[3] = { 12, 24, 48 };
  const double expected_order[5] = { 0, 0, 0.9, 1.7, 2.6 };
  const double finest[5] = { 0, 0, 0.03, 0.01, 2e-3 };
  for(const Surface& surface : surfaces())
    for(int degree = 2; degree <= 4; ++degree)
    {
      Errors e[3];
      for(int i = 0; i < 3; ++i)
      {
        const Arrays a = sampled(surface, resolutions[i]);
        e[i] = errors(surface, a.points, by_jets(a, degree));
      }
      const double order = std::log2(e[0].curvature / e[2].curvature) / 2;
      const double tensor_order = std::log2(e[0].tensor / e[2].tensor) / 2;
      std::cout << surface.name << ", degree " << degree << ": error " << e[0].curvature << " " << e[1].curvature << " "
                << e[2].curvature << ", order " << order << "; tensors " << e[2].tensor << ", order " << tensor_order
                << "; worst " << e[2].worst << std::endl;
      GDP_CHECK(order > expected_order[degree] || e[2].curvature < 1e-10);
      GDP_CHECK(tensor_order > expected_order[degree] || e[2].tensor < 1e-10);
      GDP_CHECK(e[2].curvature < finest[degree]);
    }
}

// The same numbers as CGAL's fitting with its own solver on the same points.
void test_least_squares()
{
  typedef CGAL::Simple_cartesian<double> Kernel;
  Random random;
  for(int trial = 0; trial < 200; ++trial)
  {
    GDPI::Jet_fitter<>::Points points(1, Kernel::Point_3(0, 0, 0));
    for(int i = 0; i < 24; ++i)
    {
      const double x = random(), y = random();
      points.emplace_back(x, y, 0.2 * x - 0.1 * y + 0.4 * x * x - 0.3 * x * y + 0.1 * y * y + 0.02 * random());
    }
    const auto compare = [&](auto fit, int degree)
    {
      CGAL::Monge_via_jet_fitting<Kernel> plain;
      auto expected = plain(points.begin(), points.end(), degree, 2);
      expected.comply_wrt_given_normal(Kernel::Vector_3(0, 0, 1));
      Principal_curvatures computed = { 0, 0, Vec3::Zero(), Vec3::Zero() };
      GDP_CHECK(fit(points, Vec3::UnitZ(), computed));
      const double tolerance = 1e-11 * plain.condition_number();
      GDP_CHECK_NEAR(computed.min_curvature, -expected.principal_curvatures(0), tolerance);
      GDP_CHECK_NEAR(computed.max_curvature, -expected.principal_curvatures(1), tolerance);
      const auto d = expected.maximal_principal_direction();
      GDP_CHECK_NEAR(std::abs(computed.min_direction.dot(Vec3(d.x(), d.y(), d.z()))), 1, tolerance);
    };
    compare(GDPI::Jet_fitter<>(2), 2);
    compare(GDPI::Jet_fitter<>(3), 3);
    compare(GDPI::Jet_fitter<>(4), 4);
  }
}

void test_scales_and_offsets()
{
  for(const Surface& surface : surfaces())
    for(int degree : { 2, 4 })
    {
      const Arrays a = sampled(surface, 12);
      const std::vector<Principal_curvatures> expected = by_jets(a, degree);
      for(double scale : { 1e-150, 1e-3, 1., 1e3, 1e6, 1e150 })
        for(double offset : { 0., 1e7 })
        {
          Arrays b = a;
          for(Vec3& p : b.points)
            p = scale * (p + offset * Vec3(1, -0.5, 0.25));
          const std::vector<Principal_curvatures> computed = by_jets(b, degree);
          // rounding of the points over the square of the edges
          const double tolerance = offset == 0 ? 1e-8 : 1e-2;
          for(std::size_t v = 0; v < a.points.size(); ++v)
            if(surface.is_inside(a.points[v]))
            {
              GDP_CHECK(is_sound(computed[v]));
              GDP_CHECK_NEAR(computed[v].min_curvature * scale, expected[v].min_curvature, tolerance);
              GDP_CHECK_NEAR(computed[v].max_curvature * scale, expected[v].max_curvature, tolerance);
            }
        }
    }
}

void test_signs_and_directions()
{
  Arrays sphere = sampled(ellipsoid("sphere", Vec3(1, 1, 1)), 24);
  for(const Principal_curvatures& c : by_jets(sphere, 2))
  {
    GDP_CHECK_NEAR(c.min_curvature, 1, 0.02);
    GDP_CHECK_NEAR(c.max_curvature, 1, 0.02);
  }
  for(Vec3& n : sphere.normals)
    n = -n;
  for(const Principal_curvatures& c : by_jets(sphere, 2))
  {
    GDP_CHECK_NEAR(c.min_curvature, -1, 0.02);
    GDP_CHECK_NEAR(c.max_curvature, -1, 0.02);
  }
  for(Vec3& n : sphere.normals)
    n.setZero();
  for(const Principal_curvatures& c : by_jets(sphere, 2))
  {
    GDP_CHECK(is_sound(c));
    // without normals the far side of the neighborhood is not told apart, the size is still right
    GDP_CHECK_NEAR(std::abs(c.min_curvature), 1, 0.02);
  }

  const Surface tube = cylinder();
  const Arrays a = sampled(tube, 24);
  const std::vector<Principal_curvatures> c = by_jets(a, 2);
  for(std::size_t v = 0; v < c.size(); ++v)
    if(tube.is_inside(a.points[v]))
    {
      GDP_CHECK_NEAR(c[v].min_curvature, 0, 0.02);
      GDP_CHECK_NEAR(c[v].max_curvature, 1, 0.02);
      GDP_CHECK(std::abs(c[v].min_direction.z()) > 0.999);
      GDP_CHECK(std::abs(c[v].max_direction.z()) < 0.05);
      GDP_CHECK(std::abs(c[v].max_direction.dot(a.normals[v])) < 0.05);
    }
}

void test_concurrency_and_cancellation()
{
  const Arrays a = sampled(torus(), 30);
  for(int degree = 2; degree <= 4; ++degree)
  {
    const std::vector<Principal_curvatures> in_sequence = by_jets(a, degree);
    const std::vector<Principal_curvatures> in_parallel = by_jets<CGAL::Parallel_tag>(a, degree);
    for(std::size_t v = 0; v < a.points.size(); ++v)
      GDP_CHECK(is_same(in_sequence[v], in_parallel[v]));
  }

  const auto watch = [&](auto tag)
  {
    std::vector<Principal_curvatures> result;
    std::vector<double> progress;
    bool is_inside = false;
    GDP_CHECK(GDPI::jet_curvatures(
      std::is_same<decltype(tag), CGAL::Parallel_tag>::value, a.points, a.offsets, a.neighbors, a.normals, 2,
      [&](double x) {
        GDP_CHECK(!is_inside);
        is_inside = true;
        progress.push_back(x);
        is_inside = false;
        return true;
      },
      result));
    GDP_CHECK(progress.size() >= a.points.size() / 2000);
    GDP_CHECK(std::is_sorted(progress.begin(), progress.end()));
    GDP_CHECK(progress.front() > 0 && progress.back() == 1);

    int calls = 0;
    GDP_CHECK(!GDPI::jet_curvatures(
      std::is_same<decltype(tag), CGAL::Parallel_tag>::value, a.points, a.offsets, a.neighbors, a.normals, 2,
      [&](double) { return ++calls < 3; }, result));
    GDP_CHECK(calls == 3);
  };
  watch(CGAL::Sequential_tag());
  watch(CGAL::Parallel_tag());
}

Arrays with(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles, const Vec3& normal)
{
  Arrays a;
  a.points = points;
  a.triangles = triangles;
  a.normals.assign(points.size(), normal);
  a.connect();
  return a;
}

void test_degenerate_neighborhoods_of_jets()
{
  const Vec3 up = Vec3::UnitZ();
  const std::vector<Vec3> corners = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1) };
  const std::vector<Triangle> tetrahedron = { {{ 0, 2, 1 }}, {{ 0, 1, 3 }}, {{ 1, 2, 3 }}, {{ 0, 3, 2 }} };
  for(int degree = 2; degree <= 4; ++degree)
  {
    by_jets(Arrays(with({}, {}, up)), degree);

    // too few points: flat, in a frame orthogonal to the normal
    for(const Arrays& a :
        {with({Vec3(1, 2, 3)}, {}, up), with({corners[0], corners[1], corners[2]}, {{{0, 1, 2}}}, up),
         with(corners, tetrahedron, Vec3(1, 1, 1).normalized()), with(corners, tetrahedron, Vec3::Zero())})
      for(const Principal_curvatures& c : by_jets(a, degree))
      {
        GDP_CHECK(is_flat(c));
        GDP_CHECK_NEAR(c.min_direction.dot(a.normals[0]), 0, 1e-15);
        GDP_CHECK_NEAR(c.max_direction.dot(a.normals[0]), 0, 1e-15);
      }

    // a grid folded into a point, a line, and a line far away: flat; into few points: whatever is finite
    const Arrays grid = grid_mesh(8, 8, false, false, [](double u, double v) { return Vec3(u, v, 0); });
    const Vec3 along(0.6, 0.7, -0.4);
    const std::vector<std::function<Vec3(const Vec3&)> > folds = {
      [](const Vec3&) { return Vec3(0.1, 0.2, 0.3); },
      [&](const Vec3& p) { return Vec3(p.x() * along); },
      [&](const Vec3& p) { return Vec3((p.x() + 3 * p.y()) * along + Vec3(1e7, -1e7, 1e7)); },
      [](const Vec3& p) { return Vec3(std::round(2 * p.x()), std::round(2 * p.y()), 0); },
      [](const Vec3& p) { return Vec3(p.x(), 1e-9 * p.y(), 0.1 * p.x() * p.x()); },
      [](const Vec3& p) { return Vec3(p.x(), 1e-200 * p.y(), 1e-300); } };
    for(std::size_t i = 0; i < folds.size(); ++i)
    {
      std::vector<Vec3> points;
      for(const Vec3& p : grid.points)
        points.push_back(folds[i](p));
      for(const Vec3& normal : { up, Vec3(0, 0, 0), Vec3(0.6, 0.7, -0.4).normalized() })
        for(const Principal_curvatures& c : by_jets(with(points, grid.triangles, normal), degree))
          GDP_CHECK(i < 3 ? is_flat(c) : is_sound(c));
    }

    // every other point doubled: the rest still tells the sphere
    Arrays sphere = sampled(ellipsoid("sphere", Vec3(1, 1, 1)), 16);
    for(std::size_t v = 0; v + 1 < sphere.points.size(); v += 7)
      sphere.points[v] = sphere.points[sphere.neighbors[sphere.offsets[v]]];
    for(const Principal_curvatures& c : by_jets(sphere, degree))
    {
      GDP_CHECK(is_sound(c));
      GDP_CHECK_NEAR(c.min_curvature, 1, 0.15);
    }

    // coarse closed surfaces; a thin one, whose far side is near
    for(const Vec3& axes : { Vec3(1, 1, 1), Vec3(1, 1, 1e-3), Vec3(1, 1e-3, 1e-3) })
      for(int n : { 1, 2, 8 })
        for(const Principal_curvatures& c : by_jets(sampled(ellipsoid("", axes), n), degree))
          GDP_CHECK(is_sound(c));

    // a border: the corner of a paraboloid has neighbors on one side only
    const Surface bowl = graph("bowl", [](double x, double y) { return -(x * x + y * y) / 2; },
                               [](double x, double y) { return std::array<double, 5>{{ -x, -y, -1, 0, -1 }}; });
    const Arrays a = sampled(bowl, 32);
    const std::vector<Principal_curvatures> at_border = by_jets(a, degree);
    for(std::size_t v = 0; v < a.points.size(); ++v)
    {
      GDP_CHECK(is_sound(at_border[v]));
      GDP_CHECK_NEAR(at_border[v].max_curvature, bowl.curvatures(a.points[v]).max_curvature, 0.1);
    }
  }

  // the apex of a fan with more neighbors than a fit takes
  for(int valence : { 3, 4, 5, 6, 12, 126, 127, 128, 1000 })
  {
    std::vector<Vec3> points(1, Vec3(0, 0, 1));
    std::vector<Triangle> triangles;
    for(int i = 0; i < valence; ++i)
    {
      const double angle = two_pi * i / valence, next = two_pi * (i + 0.5) / valence;
      points.push_back(Vec3(0.1 * std::cos(angle), 0.1 * std::sin(angle), std::sqrt(0.99)));
      points.push_back(Vec3(0.2 * std::cos(next), 0.2 * std::sin(next), std::sqrt(0.96)));
      const int p = 1 + 2 * i, q = 1 + 2 * ((i + 1) % valence);
      triangles.push_back({{ 0, p, q }});
      triangles.push_back({{ p, p + 1, q }});
    }
    Arrays a = with(points, triangles, up);
    for(std::size_t v = 0; v < points.size(); ++v)
      a.normals[v] = points[v];
    const Principal_curvatures apex = by_jets(a, 2)[0];
    GDP_CHECK_NEAR(apex.min_curvature, 1, 0.05);
    GDP_CHECK_NEAR(apex.max_curvature, 1, 0.05);
  }
}

// The definition, with everything that cancels in it: II t = k g t.
void check_against_definition(const Vec3 p[3], const Vec3 n[3])
{
  Eigen::Matrix<double, 3, 2> t, dn;
  t << p[1] - p[0], p[2] - p[0];
  dn << n[1] - n[0], n[2] - n[0];
  const Eigen::Matrix2d g = t.transpose() * t, product = t.transpose() * dn;
  const Eigen::Matrix2d second = (product + product.transpose()) / 2;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> eigen(second, g);

  const Principal_curvatures c = GDPI::triangle_curvatures(p[0], p[1], p[2], n[0], n[1], n[2]);
  const double tolerance = 1e-12 * eigen.eigenvalues().cwiseAbs().maxCoeff() * g.trace() / std::sqrt(g.determinant());
  GDP_CHECK(is_sound(c));
  GDP_CHECK_NEAR(c.min_curvature, eigen.eigenvalues()[0], tolerance);
  GDP_CHECK_NEAR(c.max_curvature, eigen.eigenvalues()[1], tolerance);
  const Vec3 direction = (t * eigen.eigenvectors().col(1)).normalized();
  GDP_CHECK_NEAR(std::abs(direction.dot(c.max_direction)), 1, 1e-6);
}

void test_curvatures_from_normals()
{
  // on a unit sphere the normals change as the points do: exact, whatever the triangle
  Random random;
  for(int trial = 0; trial < 300; ++trial)
  {
    Vec3 p[3], n[3];
    for(int i = 0; i < 3; ++i)
    {
      p[i] = Vec3(random(), random(), random()).normalized();
      n[i] = Vec3(random(), random(), random()).normalized();
    }
    const double height = (p[1] - p[0]).cross(p[2] - p[0]).norm();
    if(height < 1e-2)
      continue;
    for(double scale : { 1e-150, 1., 1e150 })
    {
      const Principal_curvatures c =
        GDPI::triangle_curvatures(scale * p[0], scale * p[1], scale * p[2], p[0], p[1], p[2]);
      GDP_CHECK(is_sound(c));
      GDP_CHECK_NEAR(c.min_curvature * scale, 1, 1e-12);
      GDP_CHECK_NEAR(c.max_curvature * scale, 1, 1e-12);
    }
    check_against_definition(p, n);
  }

  for(const Surface& surface : surfaces())
  {
    Errors e[2];
    for(int i = 0; i < 2; ++i)
    {
      const Arrays a = sampled(surface, 24 << i);
      std::vector<Vec3> where;
      std::vector<Principal_curvatures> computed;
      for(const Triangle& t : a.triangles)
      {
        where.push_back((a.points[t[0]] + a.points[t[1]] + a.points[t[2]]) / 3);
        computed.push_back(GDPI::triangle_curvatures(a.points[t[0]], a.points[t[1]], a.points[t[2]],
                                                     a.normals[t[0]], a.normals[t[1]], a.normals[t[2]]));
      }
      e[i] = errors(surface, where, computed);
    }
    std::cout << surface.name << ", normals: error " << e[0].curvature << " " << e[1].curvature << std::endl;
    GDP_CHECK(e[1].curvature < 0.02);
    GDP_CHECK(e[1].tensor < 0.1);
    GDP_CHECK(e[1].curvature < 0.6 * e[0].curvature || e[1].curvature < 1e-3);
  }
}

void test_curvatures_from_corners()
{
  for(const Surface& surface : surfaces())
  {
    const Arrays a = sampled(surface, 48);
    std::vector<Principal_curvatures> at_corners = by_jets(a, 3);
    Random random;
    for(Principal_curvatures& c : at_corners) // a direction and its opposite are the same
    {
      if(random() < 0) c.min_direction = -c.min_direction;
      if(random() < 0) c.max_direction = -c.max_direction;
    }
    std::vector<Vec3> where;
    std::vector<Principal_curvatures> computed;
    for(const Triangle& t : a.triangles)
    {
      where.push_back((a.points[t[0]] + a.points[t[1]] + a.points[t[2]]) / 3);
      computed.push_back(GDPI::triangle_curvatures(a.points[t[0]], a.points[t[1]], a.points[t[2]],
                                                   at_corners[t[0]], at_corners[t[1]], at_corners[t[2]]));
      const Vec3 normal = (a.points[t[1]] - a.points[t[0]]).cross(a.points[t[2]] - a.points[t[0]]).normalized();
      GDP_CHECK_NEAR(computed.back().min_direction.dot(normal), 0, 1e-12);
      GDP_CHECK_NEAR(computed.back().max_direction.dot(normal), 0, 1e-12);
    }
    const Errors e = errors(surface, where, computed);
    std::cout << surface.name << ", corners: error " << e.curvature << std::endl;
    GDP_CHECK(e.curvature < 0.02);
    GDP_CHECK(e.tensor < 0.06);
  }

  // a tensor of the plane comes back as it is
  const double s = std::sqrt(0.5);
  const Principal_curvatures c = { -2, 3, Vec3(s, s, 0), Vec3(s, -s, 0) };
  const Principal_curvatures d = GDPI::triangle_curvatures(Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(0.2, 3, 1), c, c, c);
  GDP_CHECK((tensor(d) - tensor(c)).norm() < 1e-14);
  GDP_CHECK_NEAR(d.min_curvature, -2, 1e-14);
  GDP_CHECK_NEAR(d.max_curvature, 3, 1e-14);
}

void test_degenerate_triangles()
{
  const Vec3 n[3] = { Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(1, 0, 0) };
  const Principal_curvatures c = { -2, 3, Vec3::UnitX(), Vec3::UnitY() };
  const double tiny = std::numeric_limits<double>::denorm_min();
  const Vec3 along(0.3, -0.4, 0.7);
  const std::vector<std::array<Vec3, 3> > flat = {
    {{ along, along, along }}, {{ along, along, 2 * along }}, {{ 0 * along, along, 3 * along }},
    {{ 1e7 * along, 1e7 * along, -1e7 * along }}, {{ Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 1e-14, 0) }},
    {{ Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, tiny, 0) }}, {{ 1e150 * along, -1e150 * along, 0 * along }} };
  const std::vector<std::array<Vec3, 3> > finite = {{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 1e-9, 0)}},
                                                    {{Vec3(0, 0, 0), Vec3(1e-9, 0, 0), Vec3(0, 1, 0)}},
                                                    {{Vec3(0, 0, 0), Vec3(tiny, 0, 0), Vec3(0, tiny, 0)}},
                                                    {{Vec3(0, 0, 0), Vec3(1e150, 0, 0), Vec3(0, 1e145, 0)}}};
  std::array<int, 3> order = {{ 0, 1, 2 }};
  do
  {
    for(const std::array<Vec3, 3>& p : flat)
    {
      GDP_CHECK(is_flat(GDPI::triangle_curvatures(p[order[0]], p[order[1]], p[order[2]], n[0], n[1], n[2])));
      GDP_CHECK(is_flat(GDPI::triangle_curvatures(p[order[0]], p[order[1]], p[order[2]], c, c, c)));
    }
    for(const std::array<Vec3, 3>& p : finite)
    {
      GDP_CHECK(is_sound(GDPI::triangle_curvatures(p[order[0]], p[order[1]], p[order[2]], n[0], n[1], n[2])));
      GDP_CHECK(is_sound(GDPI::triangle_curvatures(p[order[0]], p[order[1]], p[order[2]], c, c, c)));
    }
  }
  while(std::next_permutation(order.begin(), order.end()));
}

void test_eigenpairs()
{
  Random random;
  for(int trial = 0; trial < 1000; ++trial)
  {
    const GDPI::Tangent_frame frame = GDPI::frame_of_normal(Vec3(random(), random(), random()));
    GDP_CHECK_NEAR(frame.e1.dot(frame.e2), 0, 1e-15);
    const double scale = std::pow(10., 100 * random());
    const double a = scale * random(), b = scale * random() * (trial % 3),
                 c = trial % 2 ? a * (1 + 1e-9 * random()) : scale * random();
    const Principal_curvatures k = GDPI::diagonalize(a, b, c, frame);
    GDP_CHECK(is_sound(k));
    const Mat3 expected = a * frame.e1 * frame.e1.transpose() + c * frame.e2 * frame.e2.transpose() +
                          b * (frame.e1 * frame.e2.transpose() + frame.e2 * frame.e1.transpose());
    GDP_CHECK((tensor(k) - expected).norm() <= 1e-14 * scale);
  }
  const GDPI::Tangent_frame frame = GDPI::frame_of_normal(Vec3::UnitZ());
  const Principal_curvatures umbilic = GDPI::diagonalize(0.5, 0, 0.5, frame);
  GDP_CHECK(umbilic.min_curvature == 0.5 && umbilic.max_curvature == 0.5);
  GDP_CHECK(umbilic.max_direction == frame.e1);
}

int main()
{
  test_convergence_of_jets();
  test_least_squares();
  test_scales_and_offsets();
  test_signs_and_directions();
  test_concurrency_and_cancellation();
  test_degenerate_neighborhoods_of_jets();
  test_curvatures_from_normals();
  test_curvatures_from_corners();
  test_degenerate_triangles();
  test_eigenpairs();
  return GDP_TEST_RESULT();
}
