// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Degenerate faces, extreme coordinates, long runs: finite results that depend continuously on the input.

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/enhance_details.h>
#include <CGAL/Gradient_domain_processing/estimate_curvatures.h>
#include <CGAL/Gradient_domain_processing/fit_to_normals.h>
#include <CGAL/Gradient_domain_processing/smooth.h>
#include <CGAL/Gradient_domain_processing/stitch.h>

#include <iostream>
#include <string>
#include <vector>

namespace GDP = CGAL::Gradient_domain_processing;
using namespace gdp_test;

typedef GDP::Curvature_metric_kind Kind;
typedef GDP::Curvature_estimator Estimator;

struct Settings
{
  Kind kind = Kind::EMBEDDING;
  Estimator estimator = Estimator::JETS;
  double weight = 1e-3, scale = 0;
  int iterations = 1;
  double curvature_weight = 0.1;
};

template <class Triangle_mesh>
GDP::Error_code run(Triangle_mesh& mesh, const Settings& s)
{
  return GDP::smooth(mesh, GDP::parameters::gradient_weight(s.weight)
                             .gradient_scale(s.scale)
                             .curvature_metric_kind(s.kind)
                             .curvature_weight(s.curvature_weight)
                             .curvature_estimator(s.estimator)
                             .number_of_iterations(s.iterations));
}

std::vector<Settings> all_settings()
{
  std::vector<Settings> result(1);
  for(double scale : {0., 2.})
    for(Estimator estimator : {Estimator::JETS, Estimator::NORMALS})
      for(Kind kind :
          {Kind::EMBEDDING, Kind::EDGE_AWARE, Kind::ANISOTROPIC, Kind::PRESERVE_CONVEX, Kind::PRESERVE_CONCAVE})
      {
        Settings s;
        s.kind = kind;
        s.estimator = estimator;
        s.scale = scale;
        result.push_back(s);
      }
  return result;
}

// ---- degenerate faces

// Splits the edge ab on the side of face `f` only: the gap between the halves and the neighbor is a cap a, b, m, of no
// height where m is on the edge.
Shape with_cap(Shape shape, int f, double along, const Vec& offset)
{
  const auto t = shape.triangles[f];
  const int m = int(shape.points.size());
  shape.points.push_back(shape.points[t[0]] + along * (shape.points[t[1]] - shape.points[t[0]]) + offset);
  shape.triangles[f] = {{t[0], m, t[2]}};
  shape.triangles.push_back({{m, t[1], t[2]}});
  shape.triangles.push_back({{t[0], t[1], m}});
  return shape;
}

struct Case
{
  std::string name;
  Shape shape;
};

std::vector<Case> degenerate_cases()
{
  std::vector<Case> cases;
  const auto add = [&](const std::string& name, const Shape& shape) { cases.push_back({name, shape}); };
  for(bool is_open : {false, true})
  {
    const Shape base = is_open ? jittered_square(6).noisy(0.01) : sphere(4).noisy(0.02);
    const std::string where = is_open ? "square, " : "sphere, ";
    const int n = int(base.triangles.size());

    Shape shape = base;
    shape.points[shape.triangles[5][0]] = shape.points[shape.triangles[5][1]];
    add(where + "two vertices coincide", shape);
    shape.points[shape.triangles[5][2]] = shape.points[shape.triangles[5][1]];
    add(where + "a face is a point", shape);
    for(double h : {1e-6, 1e-12, 1e-16, 1e-300})
    {
      shape.points[shape.triangles[5][0]] = shape.points[shape.triangles[5][1]] + h * Vec(1, 2, -1);
      add(where + "needle", shape);
      add(where + "cap", with_cap(base, 9, 0.3, h * Vec(1, -1, 0.5)));
      add(where + "needle and cap", with_cap(base, 9, h, Vec(0, 0, 0)));
    }
    add(where + "cap of 180 degrees", with_cap(base, 9, 0.5, Vec(0, 0, 0)));
    add(where + "cap at a vertex", with_cap(base, 9, 1, Vec(0, 0, 0)));
    add(where + "cap beyond the edge", with_cap(base, 9, 1.5, Vec(0, 0, 0)));
    add(where + "folded cap", with_cap(base, 9, 0.5, Vec(0, 0, -1e-9)));
    shape = base;
    for(int f = 0; f < n; f += 3)
      shape = with_cap(shape, f, 0.5, Vec(0, 0, 0));
    add(where + "many caps", shape);
    shape = base;
    for(int f = 0; f < 8; ++f)
      shape = with_cap(shape, int(shape.triangles.size()) - 1, 0.5, Vec(0, 0, 0));
    add(where + "a stack of caps", shape);
    add(where + "flattened to a line", base.mapped([](const Vec& p) { return Vec(p.x(), 2 * p.x(), -p.x()); }));
    add(where + "flattened to a plane", base.mapped([](const Vec& p) { return Vec(p.x(), p.y(), 0.5 * p.x()); }));
    add(where + "flattened by 1e-12",
        base.mapped([](const Vec& p) { return Vec(p.x(), 1e-12 * p.y(), 1e-12 * p.z()); }));
    add(where + "half of it is a point", base.mapped([](const Vec& p) { return p.x() < 0.3 ? Vec(0, 0, 0) : p; }));
    add(where + "all of it is a point", base.mapped([](const Vec&) { return Vec(3, 4, 5); }));
    for(double h : {0., 1e-12})
    {
      add(where + "a component is a point", base + sphere(2).scaled(h).moved(Vec(3, 0, 0)));
      add(where + "a component is a line",
          base + square(3).mapped([&](const Vec& p) { return Vec(3 + p.x() + p.y(), h * p.y(), 0); }));
      add(where + "a strip of needles", base + grid(10, 1, [&](double u, double v) { return Vec(3 + u, h * v, 0); }));
      add(where + "a strip of caps beside a border",
          grid(10, 10, [&](double u, double v) { return Vec(u, v == 1 ? 0.9 + h : v, 0.1 * u * u); }));
      add(where + "a strip inside", grid(10, 10, [&](double u, double v) {
            return Vec(std::abs(u - 0.5) < 0.01 ? 0.4 + h : u, v, 0.1 * u * u);
          }));
    }
    add(where + "components of very different size", base + base.scaled(1e-8).moved(Vec(3, 0, 0)));
    for(double size : {1e-150, 1e-155, 1e-159}) // their squares are hardly numbers any more
      add(where + "a component whose area underflows", base.moved(Vec(3, 0, 0)) + sphere(2).scaled(size));
    add(where + "components of the same place", base + base);
    shape = base;
    shape.points.push_back(Vec(1, 2, 3));
    shape.points.push_back(base.points[0]);
    add(where + "vertices without a face", shape);
    add(where + "a single face", [] {
      Shape t;
      t.points = {Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0)};
      t.triangles = {{{0, 1, 2}}};
      return t;
    }());
    add(where + "a single face, a line", [] {
      Shape t;
      t.points = {Vec(0, 0, 0), Vec(1, 0, 0), Vec(3, 0, 0)};
      t.triangles = {{{0, 1, 2}}};
      return t;
    }());
  }
  return cases;
}

void check_finite(const std::string& name, const Mesh& mesh, const Mesh& before, GDP::Error_code code)
{
  if(!GDP_CHECK(code == GDP::OK))
  {
    std::cerr << "  " << name << ": " << GDP::get_error_message(code) << std::endl;
    GDP_CHECK(same_points(mesh, before));
  }
  if(!GDP_CHECK(is_finite(mesh)))
    std::cerr << "  " << name << std::endl;

  // smoothing averages: nothing leaves the bounding box by more than what obtuse angles and metrics allow
  const Eigen::MatrixXd p = positions(before), q = positions(mesh);
  const double size = (p.rowwise() - p.row(0)).cwiseAbs().maxCoeff();
  if(!GDP_CHECK((q - p).cwiseAbs().maxCoeff() <= 2 * size))
    std::cerr << "  " << name << ": moved by " << (q - p).cwiseAbs().maxCoeff() << " of " << size << std::endl;
  for(Vertex v : mesh.vertices())
    if(mesh.is_isolated(v))
      GDP_CHECK(same_bits(mesh.point(v), before.point(v)));
}

void test_degenerate_faces()
{
  for(const Case& c : degenerate_cases())
  {
    Mesh before = mesh_of(c.shape);
    GDP_CHECK(before.number_of_faces() == c.shape.triangles.size());
    for(const Settings& s : all_settings())
    {
      Mesh mesh = before;
      check_finite(c.name, mesh, before, run(mesh, s));
    }
    Mesh mesh = before;
    check_finite(c.name + ", enhanced", mesh, before, GDP::enhance_details(mesh));

    auto normal = before.add_property_map<Vertex, Vector>("v:normal", Vector(0, 0.6, 0.8)).first;
    auto curvature = before.add_property_map<Vertex, GDP::Principal_curvatures_and_directions<Kernel> >("v:k").first;
    auto patch = before.add_property_map<Vertex, int>("v:patch", 0).first;
    auto f = before.add_property_map<Vertex, double>("v:f", 0.).first;
    auto g = before.add_property_map<Vertex, double>("v:g", 17.).first;
    mesh = before;
    check_finite(c.name + ", fitted to normals", mesh, before, GDP::fit_to_normals(mesh, normal));
    GDP_CHECK(GDP::estimate_curvatures(before, curvature) == GDP::OK);
    for(Vertex v : before.vertices())
    {
      GDP_CHECK(std::isfinite(curvature[v].min_curvature) && std::isfinite(curvature[v].max_curvature));
      GDP_CHECK_NEAR(vec(curvature[v].min_direction).norm(), 1, 1e-9);
      GDP_CHECK_NEAR(vec(curvature[v].max_direction).norm(), 1, 1e-9);
      patch[v] = int(v) % 3;
      f[v] = patch[v];
    }
    GDP_CHECK(GDP::stitch(before, patch, f, g) == GDP::OK);
    double low = 0, high = 2, length = 0; // the values of f
    for(Vertex v : before.vertices())
    {
      GDP_CHECK(std::isfinite(g[v]));
      low = (std::min)(low, g[v]);
      high = (std::max)(high, g[v]);
    }
    for(auto e : before.edges())
      length =
        (std::max)(length, (vec(before.point(before.vertex(e, 0))) - vec(before.point(before.vertex(e, 1)))).norm());
    // where a component has no area to speak of, values weigh nothing and rounding decides on its constant
    const bool has_constant =
      total_area(before) > 1e-6 * length * length && c.name.find("very different size") == std::string::npos;
    if(has_constant && !GDP_CHECK(low > -1 && high < 3))
      std::cerr << "  " << c.name << ", stitched: from " << low << " to " << high << std::endl;
  }
}

// An almost-zero face does not change its neighbors more than its size warrants. In the limit of no height, a cap ties
// its middle vertex to its edge: the result is that of the mesh without it.
void test_continuity()
{
  const Shape base = sphere(4).noisy(0.02);
  const Mesh without = mesh_of(base);
  const int n = int(base.points.size());
  for(double weight : {1e-3, 1e-1})
    for(double scale : {0., 2.})
    {
      Settings s;
      s.weight = weight;
      s.scale = scale;
      Mesh expected = without;
      GDP_CHECK(run(expected, s) == GDP::OK);
      double worst = 0;
      for(double along : {0.5, 0.1, 1e-6, 0.})
        for(double h : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 0.})
        {
          Mesh mesh = mesh_of(with_cap(base, 9, along, h * Vec(0.3, -0.2, 0.5)));
          GDP_CHECK(run(mesh, s) == GDP::OK);
          double difference = 0;
          for(int v = 0; v < n; ++v)
            difference = (std::max)(difference, (vec(mesh.point(Vertex(v))) - vec(expected.point(Vertex(v)))).norm());
          worst = (std::max)(worst, difference - 10 * h);
          GDP_CHECK_NEAR(difference, 0, 10 * h + 1e-6);
        }
      std::cout << "cap against no cap: " << worst << " beyond ten times its height" << std::endl;

      // a vertex that moves onto another
      Mesh limit;
      for(double h : {0., 1e-15, 1e-12, 1e-9, 1e-6, 1e-4})
      {
        Shape shape = base;
        shape.points[base.triangles[5][0]] = base.points[base.triangles[5][1]] + h * Vec(1, -2, 0.5);
        Mesh mesh = mesh_of(shape);
        GDP_CHECK(run(mesh, s) == GDP::OK);
        if(h == 0)
          limit = mesh;
        GDP_CHECK_NEAR(distance(mesh, limit), 0, 100 * h + 1e-6);
      }
    }

  // another component, however degenerate, changes nothing but the area by which weights are normalized
  Settings s;
  Mesh alone = without, beside = mesh_of(base + sphere(2).scaled(1e-12).moved(Vec(2, 0, 0)));
  GDP_CHECK(run(alone, s) == GDP::OK);
  GDP_CHECK(run(beside, s) == GDP::OK);
  for(int v = 0; v < n; ++v)
    GDP_CHECK_NEAR((vec(beside.point(Vertex(v))) - vec(alone.point(Vertex(v)))).norm(), 0, 1e-12);
}

// ---- extreme coordinates

void test_scales_and_offsets()
{
  const Shape base = ellipsoid(4, Vec(1, 0.8, 0.6)).noisy(0.02) + jittered_square(4).noisy(0.02).moved(Vec(2, 0, 0));
  for(const Settings& s : all_settings())
  {
    Mesh expected = mesh_of(base);
    GDP_CHECK(run(expected, s) == GDP::OK);
    const Eigen::MatrixXd g = positions(expected);
    for(double scale : {1e-150, 1e-100, 1e-20, 1e-3, 1e3, 1e20, 1e100, 1e149})
    {
      Mesh mesh = mesh_of(base.scaled(scale));
      GDP_CHECK(run(mesh, s) == GDP::OK);
      GDP_CHECK_NEAR((positions(mesh) / scale - g).cwiseAbs().maxCoeff(), 0, 1e-8);
    }
    for(double shift : {1e3, 1e8})
    {
      const Vec by = shift * Vec(1, -0.7, 0.3);
      Mesh mesh = mesh_of(base.moved(by));
      GDP_CHECK(run(mesh, s) == GDP::OK);
      const double error = ((positions(mesh).rowwise() - by.transpose()) - g).cwiseAbs().maxCoeff();
      GDP_CHECK_NEAR(error, 0, shift * (s.kind == Kind::EMBEDDING || shift == 1e3 ? 1e-14 : 1e-11));
    }
  }

  // beyond the range that is promised
  for(double scale : {1e151, 1e200, 1e308})
  {
    const Mesh before = mesh_of(base.scaled(scale));
    Mesh mesh = before;
    GDP_CHECK(run(mesh, Settings()) == GDP::ERROR_INVALID_POINT);
    GDP_CHECK(same_points(mesh, before));
  }
  for(double scale : {1e-151, 1e-200, 1e-300, 1e-320})
  {
    const Mesh before = mesh_of(base.scaled(scale));
    Mesh mesh = before;
    const GDP::Error_code code = run(mesh, Settings());
    GDP_CHECK(is_finite(mesh));
    GDP_CHECK(code == GDP::OK || same_points(mesh, before));
  }

  // the small one among components of very different size is smoothed by weights of the whole: it does no harm
  for(double ratio : {1e-4, 1e-8})
  {
    const Mesh before = mesh_of(base + base.scaled(ratio).moved(Vec(5, 0, 0)));
    Mesh mesh = before;
    GDP_CHECK(run(mesh, Settings()) == GDP::OK);
    const int n = int(base.points.size());
    Mesh alone = mesh_of(base);
    GDP_CHECK(run(alone, Settings()) == GDP::OK);
    for(int v = 0; v < n; ++v)
      GDP_CHECK_NEAR((vec(mesh.point(Vertex(v))) - vec(alone.point(Vertex(v)))).norm(), 0, 10 * ratio);
    for(int v = n; v < 2 * n; ++v)
      GDP_CHECK((vec(mesh.point(Vertex(v))) - Vec(5, 0, 0)).norm() < 10 * ratio);
  }
}

void test_float()
{
  typedef CGAL::Simple_cartesian<float> Float_kernel;
  typedef CGAL::Surface_mesh<Float_kernel::Point_3> Float_mesh;
  const Shape base = sphere(4).noisy(0.02);
  for(const Settings& s : all_settings())
  {
    Float_mesh mesh;
    build(base, mesh);
    Mesh expected; // what float holds, in double
    for(auto v : mesh.vertices())
      expected.add_vertex(Point(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()));
    for(const auto& t : base.triangles)
      expected.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
    GDP_CHECK(run(mesh, s) == GDP::OK);
    GDP_CHECK(run(expected, s) == GDP::OK);
    for(auto v : mesh.vertices())
      for(int i = 0; i < 3; ++i)
        GDP_CHECK_NEAR(mesh.point(v)[i], expected.point(Vertex(int(v)))[i], 1e-6);
  }
  // a result that float does not hold is an error, and nothing is written
  Float_mesh mesh;
  build(base.scaled(2.5e38), mesh);
  const Float_mesh before = mesh;
  Settings s;
  s.scale = 1000;
  s.weight = 1;
  GDP_CHECK(run(mesh, s) == GDP::ERROR_RESULT_OUT_OF_RANGE);
  for(auto v : mesh.vertices())
    GDP_CHECK(mesh.point(v) == before.point(v));
}

// ---- long runs

void test_long_runs()
{
  const Shape open =
    jittered_square(10).mapped([](const Vec& p) { return Vec(p.x(), p.y(), 0.2 * std::sin(4 * p.x())); }).noisy(0.02);
  for(Settings s : all_settings())
  {
    if(s.scale != 0)
      continue;
    for(double weight : {1e-4, 1e-2})
    {
      s.iterations = 50;
      s.weight = weight;
      s.curvature_weight = 0.02;
      const Mesh before = mesh_of(open);
      Mesh mesh = before;
      GDP_CHECK(run(mesh, s) == GDP::OK);
      GDP_CHECK(is_finite(mesh));
      GDP_CHECK(total_area(mesh) < total_area(before));
    }
  }
}

int main()
{
  test_degenerate_faces();
  test_continuity();
  test_scales_and_offsets();
  test_float();
  test_long_runs();
  return GDP_TEST_RESULT();
}
