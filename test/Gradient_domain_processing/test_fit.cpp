// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Target gradients of the caller's choosing: functions from their gradients, cloning, and positions from normals.

#include "test_energy.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/fit_to_gradients.h>
#include <CGAL/Gradient_domain_processing/fit_to_normals.h>

#include <iostream>
#include <limits>

namespace GDP = CGAL::Gradient_domain_processing;
using namespace gdp_test;

typedef std::array<Vector, 2> Gradients;
typedef std::array<double, 2> Values;

struct Fit
{
  Mesh mesh;
  Mesh::Property_map<Vertex, Values> f, g;
  Mesh::Property_map<Face, Gradients> v;
  Mesh::Property_map<Vertex, bool> is_constrained;

  explicit Fit(const Shape& shape)
    : mesh(mesh_of(shape))
    , f(mesh.add_property_map<Vertex, Values>("v:f", Values()).first)
    , g(mesh.add_property_map<Vertex, Values>("v:g", Values()).first)
    , v(mesh.add_property_map<Face, Gradients>("f:v").first)
    , is_constrained(mesh.add_property_map<Vertex, bool>("v:constrained", false).first)
  {}

  GDP::Error_code run(double alpha, double beta)
  {
    return GDP::fit_to_gradients(mesh, f, v, g, GDP::parameters::value_weight(alpha).gradient_weight(beta)
                                                  .vertex_is_constrained_map(is_constrained).area_normalization(false));
  }

  // of a function that is linear on every face; with a normal part, which must not count
  template <class Function>
  void set_gradients_of(const Function& function, double normal_part)
  {
    for(Face t : mesh.faces())
    {
      const auto c = corners(mesh, t);
      Eigen::Matrix3d rows;
      for(int i = 0; i < 2; ++i)
        rows.row(i) = (vec(mesh.point(c[i + 1])) - vec(mesh.point(c[0]))).transpose();
      rows.row(2) = area_vector(mesh, t).normalized().transpose();
      for(int channel = 0; channel < 2; ++channel)
      {
        const Vec w = rows.inverse() * Vec(function(c[1])[channel] - function(c[0])[channel],
                                           function(c[2])[channel] - function(c[0])[channel], normal_part);
        v[t][channel] = Vector(w.x(), w.y(), w.z());
      }
    }
  }

  Eigen::MatrixXd values(const Mesh::Property_map<Vertex, Values>& map) const
  {
    Eigen::MatrixXd result(mesh.number_of_vertices(), 2);
    for(Vertex w : mesh.vertices())
      result.row(w) << map[w][0], map[w][1];
    return result;
  }

  double error_against_dense(double alpha, double beta) const
  {
    Dense_energy energy(mesh, alpha, beta);
    for(Vertex w : mesh.vertices())
      energy.is_fixed[w] = is_constrained[w];
    Eigen::MatrixXd covectors(2 * mesh.number_of_faces(), 2);
    for(Face t : mesh.faces())
      for(int channel = 0; channel < 2; ++channel)
        covectors.col(channel).segment(2 * int(t), 2) = energy.frame(t).transpose() * vec(v[t][channel]);
    return (energy.minimum(values(f), covectors) - values(g)).cwiseAbs().maxCoeff();
  }
};

Values function(const Point& p)
{
  return {{std::sin(2 * p.x()) + p.y() * p.z(), std::exp(p.x() - p.y()) - 3 * p.z()}};
}

// alpha = 0 and one value: the function itself comes back.
void test_recovery()
{
  for(double size : {1e-3, 1., 1e6})
    for(const Shape& shape : {sphere(6).scaled(size), jittered_square(10).scaled(size)})
    {
      Fit fit(shape);
      const auto exact = [&](Vertex v) {
        const Point p = fit.mesh.point(v);
        return function(Point(p.x() / size, p.y() / size, p.z() / size));
      };
      fit.set_gradients_of(exact, 5 / size);
      for(Vertex v : fit.mesh.vertices())
        fit.f[v] = {{100, -100}};
      GDP_CHECK(fit.run(0, 1) == GDP::ERROR_UNCONSTRAINED);
      fit.f[Vertex(13)] = exact(Vertex(13));
      fit.is_constrained[Vertex(13)] = true;
      GDP_CHECK(fit.run(0, 1) == GDP::OK);
      for(Vertex v : fit.mesh.vertices())
        for(int i : {0, 1})
          GDP_CHECK_NEAR(fit.g[v][i], exact(v)[i], 1e-11);
      for(int i : {0, 1})
        GDP_CHECK(same_bits(fit.g[Vertex(13)][i], fit.f[Vertex(13)][i]));
    }
}

// Fields that are no gradients, with and without values and constraints.
void test_arbitrary_fields()
{
  for(const Shape& shape : {sphere(4).noisy(0.05), jittered_square(8).noisy(0.03)})
  {
    Fit fit(shape);
    Random random;
    for(Vertex v : fit.mesh.vertices())
      fit.f[v] = {{random(), random()}};
    for(Face t : fit.mesh.faces())
      for(int channel : {0, 1})
      {
        const double x = random(), y = random(), z = random();
        fit.v[t][channel] = Vector(x, y, z);
      }
    for(double beta : {1e-3, 1., 100.})
    {
      GDP_CHECK(fit.run(1, beta) == GDP::OK);
      GDP_CHECK_NEAR(fit.error_against_dense(1, beta), 0, 1e-10);
    }
    for(int v : {3, 4, 20})
      fit.is_constrained[Vertex(v)] = true;
    for(double alpha : {0., 2.})
    {
      GDP_CHECK(fit.run(alpha, 1) == GDP::OK);
      GDP_CHECK_NEAR(fit.error_against_dense(alpha, 1), 0, 1e-11);
      for(int v : {3, 4, 20})
        GDP_CHECK(same_bits(fit.g[Vertex(v)][1], fit.f[Vertex(v)][1]));
    }
    const Eigen::MatrixXd before = fit.values(fit.g);
    for(double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    {
      const Gradients old = fit.v[Face(7)];
      fit.v[Face(7)][1] = Vector(0, bad, 0);
      GDP_CHECK(fit.run(1, 1) == GDP::ERROR_INVALID_TARGET);
      fit.v[Face(7)] = old;
    }
    GDP_CHECK(fit.values(fit.g) == before);
  }
}

// Seamless cloning: the gradients of one signal inside a region, the values of another around it.
void test_cloning()
{
  Fit fit(square(40));
  const auto background = [](const Vec& p) { return 0.5 * p.x() + 0.2 * p.y(); };
  const auto pasted = [](const Vec& p) { return 7 + std::sin(20 * p.x()) * std::sin(20 * p.y()); }; // another level
  const auto is_inside = [](const Vec& p) { return (p - Vec(0.5, 0.5, 0)).norm() < 0.3; };
  for(Vertex v : fit.mesh.vertices())
  {
    const Vec p = vec(fit.mesh.point(v));
    fit.f[v] = {{background(p), background(p)}};
    fit.is_constrained[v] = !is_inside(p);
  }
  fit.set_gradients_of([&](Vertex v) {
    const Vec p = vec(fit.mesh.point(v));
    return Values{{pasted(p), background(p)}};
  }, 0);
  GDP_CHECK(fit.run(0, 1) == GDP::OK);
  double jump = 0, detail = 0, detail_wanted = 0;
  for(auto e : fit.mesh.edges())
  {
    const Vertex v = fit.mesh.vertex(e, 0), w = fit.mesh.vertex(e, 1);
    const Vec p = vec(fit.mesh.point(v)), q = vec(fit.mesh.point(w));
    if(fit.is_constrained[v] != fit.is_constrained[w])
      jump = (std::max)(jump, std::abs(fit.g[v][0] - fit.g[w][0]));
    if((p - Vec(0.5, 0.5, 0)).norm() < 0.2)
    {
      const double wanted = pasted(q) - pasted(p), found = fit.g[w][0] - fit.g[v][0];
      detail += (found - wanted) * (found - wanted);
      detail_wanted += wanted * wanted;
    }
  }
  const double error = std::sqrt(detail / detail_wanted);
  std::cout << "cloning: largest step across the seam " << jump << " (levels differ by 7), gradients inside changed by "
            << error << std::endl;
  GDP_CHECK(jump < 0.1 * 7); // the pasted signal climbs 0.5 along an edge
  GDP_CHECK(error < 0.1);
  for(Vertex v : fit.mesh.vertices())
  {
    if(fit.is_constrained[v])
      GDP_CHECK(same_bits(fit.g[v][0], fit.f[v][0]));
    GDP_CHECK_NEAR(fit.g[v][1], fit.f[v][1], 1e-13); // its own gradients: nothing to do
  }
}

// ---- normals

double normal_noise(const Mesh& mesh) // root mean square of the angle between face normals and the sphere's
{
  double sum = 0, area = 0;
  for(Face f : mesh.faces())
  {
    const Vec n = area_vector(mesh, f), p = vec(mesh.point(corners(mesh, f)[0])) + vec(mesh.point(corners(mesh, f)[1]))
                                            + vec(mesh.point(corners(mesh, f)[2]));
    const double angle = std::acos((std::min)(1., n.normalized().dot(p.normalized())));
    sum += n.norm() * angle * angle;
    area += n.norm();
  }
  return std::sqrt(sum / area);
}

void test_normals()
{
  const Mesh clean = mesh_of(sphere(16, 0.2)), noisy = mesh_of(sphere(16, 0.2).noisy(0.02));
  Mesh with_normals = clean;
  auto exact = with_normals.add_property_map<Vertex, Vector>("v:exact").first;
  auto disturbed = with_normals.add_property_map<Vertex, Vector>("v:disturbed").first;
  Random random;
  for(Vertex v : clean.vertices())
  {
    exact[v] = clean.point(v) - Point(0, 0, 0);
    const double x = random(), y = random(), z = random();
    disturbed[v] = exact[v] + 0.3 * Vector(x, y, z);
  }
  for(GDP::Normal_fit_kind kind : {GDP::Normal_fit_kind::FACES, GDP::Normal_fit_kind::EDGES})
  {
    const auto fit = [&](Mesh& mesh, const Mesh::Property_map<Vertex, Vector>& normals, double lambda, double beta) {
      return GDP::fit_to_normals(
        mesh, normals,
        GDP::parameters::normal_projection_weight(1).gradient_scale(lambda).gradient_weight(beta).normal_fit_kind(
          kind));
    };

    // its own normals: an edge of the sphere is orthogonal to the sum of the normals at its ends
    Mesh mesh = clean;
    GDP_CHECK(fit(mesh, exact, 1, 0) == GDP::OK);
    GDP_CHECK_NEAR(distance(mesh, clean), 0, kind == GDP::Normal_fit_kind::EDGES ? 1e-12 : 0.005);

    // true normals on noisy positions
    mesh = noisy;
    GDP_CHECK(fit(mesh, exact, 1, 0) == GDP::OK);
    std::cout << "normals of a noisy sphere: off by " << normal_noise(noisy) << ", fitted " << normal_noise(mesh)
              << ", without noise " << normal_noise(clean) << std::endl;
    GDP_CHECK(normal_noise(mesh) < 0.25 * normal_noise(noisy));
    double radius_noise = 0;
    for(Vertex v : mesh.vertices())
      radius_noise = (std::max)(radius_noise, std::abs(vec(mesh.point(v)).norm() - 1));
    GDP_CHECK(radius_noise < 0.02);

    // disturbed normals are of less use, unless they are smoothed first
    Mesh raw = clean, processed = clean;
    GDP_CHECK(fit(raw, disturbed, 1, 1e-3) == GDP::OK);
    GDP_CHECK(fit(processed, disturbed, 0, 1e-3) == GDP::OK);
    std::cout << "disturbed normals: off by " << normal_noise(raw) << ", processed first " << normal_noise(processed)
              << std::endl;
    GDP_CHECK(normal_noise(processed) < 0.5 * normal_noise(raw));

    // sharpened normals are not those given
    Mesh sharpened = clean;
    GDP_CHECK(fit(sharpened, disturbed, 2, 1e-3) == GDP::OK);
    GDP_CHECK(normal_noise(sharpened) > 1.2 * normal_noise(raw));

  }

  // what cannot be used
  Mesh mesh = noisy;
  const auto fit = [&](Mesh& m, const Mesh::Property_map<Vertex, Vector>& normals, double lambda, double beta) {
    return GDP::fit_to_normals(m, normals, GDP::parameters::gradient_scale(lambda).gradient_weight(beta));
  };
  mesh = noisy;
  disturbed[Vertex(5)] = Vector(0, std::numeric_limits<double>::quiet_NaN(), 0);
  GDP_CHECK(fit(mesh, disturbed, 1, 0) == GDP::ERROR_INVALID_TARGET);
  GDP_CHECK(same_points(mesh, noisy));
  disturbed[Vertex(5)] = Vector(0, 0, 0); // no normal: nothing is asked of the edges but by their other ends
  GDP_CHECK(fit(mesh, disturbed, 1, 0) == GDP::OK);
  for(Vertex v : mesh.vertices())
    disturbed[v] = Vector(0, 0, 0);
  mesh = noisy;
  GDP_CHECK(fit(mesh, disturbed, 1, 0) == GDP::OK);
  GDP_CHECK(same_points(mesh, noisy));
}

void test_rotations()
{
  const Vec a = Vec(1, 2, 3).normalized(), b = Vec(-2, 1, 1).normalized(), axis = a.cross(b).normalized();
  const auto check = [](const Vec& from, const Vec& to, const Vec& x, const Vec& expected) {
    GDP_CHECK_NEAR((GDP::internal::rotated(from, to, x) - expected).norm(), 0, 1e-12);
  };
  check(a, b, a, b);
  check(a, b, axis, axis);
  check(a, b, axis.cross(a), axis.cross(b));
  check(a, a, b, b);
  check(a, -a, a, -a);
}

// The planes of single triangles, by the formula: how far the triangle is believed against its corners.
void test_planes()
{
  using namespace GDP::internal;
  Indexed_triangles mesh;
  mesh.points = {Vec(0, 0, 0), Vec(1, 0, 0), Vec(0.2, 0.9, 0)};
  mesh.triangles = {{{0, 1, 2}}};
  mesh.index_corners();
  for(double tilt : {0.02, 0.2, 0.6})
    for(double wrong : {0., 0.01, 0.1})
    {
      const Vec has = Vec(tilt, -tilt / 2, 1).normalized();
      Signal normals(3, 3), wanted(3, 3);
      Vec wants(0, 0, 0);
      double squares = 0;
      for(int i = 0; i < 3; ++i)
      {
        normals.row(i) = has.transpose();
        const Vec w = (has + wrong * Vec(i - 0.5, 1, 0.3 * i)).normalized();
        wanted.row(i) = w.transpose();
        wants += w;
        squares += (w - has).squaredNorm() / 3;
      }
      wants.normalize();
      const Vec up(0, 0, 1);
      Eigen::Matrix3d turn = Eigen::Quaterniond::FromTwoVectors(has, wants).toRotationMatrix();
      const double own = std::pow((up - has).norm(), 4), bound = std::pow(36 * squares, 2);
      const Vec m = (own / (own + bound) * (turn * up) + bound / (own + bound) * wants).normalized();
      const Normal_fit fit(mesh, normals, wanted, GDP::Normal_fit_kind::FACES);
      const Vec edge = mesh.points[2] - mesh.points[1];
      std::array<double, 3> along;
      fit.residual(0, 1, 2, along);
      GDP_CHECK_NEAR((Vec(along[0], along[1], along[2]) + m.dot(edge) * m).norm(), 0, 1e-10);
    }
}

int main()
{
  test_rotations();
  test_planes();
  test_recovery();
  test_arbitrary_fields();
  test_cloning();
  test_normals();
  return GDP_TEST_RESULT();
}
