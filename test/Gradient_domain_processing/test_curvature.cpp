// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Curvatures and curvature metrics through the public functions, against surfaces whose curvatures are known.

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/estimate_curvatures.h>
#include <CGAL/Gradient_domain_processing/curvature_metric.h>
#include <CGAL/Gradient_domain_processing/embedding_metric.h>

#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/Polygon_mesh_processing/interpolated_corrected_curvatures.h>
#endif

#include <functional>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace GDP = CGAL::Gradient_domain_processing;
using namespace gdp_test;

typedef GDP::Principal_curvatures_and_directions<Kernel> Curvature;
typedef Eigen::Matrix3d Mat;
typedef GDP::Curvature_metric_kind Kind;

Vector to_vector(const Vec& v) { return Vector(v.x(), v.y(), v.z()); }

Mat tensor(const Curvature& k)
{
  const Vec a = vec(k.min_direction), b = vec(k.max_direction);
  return k.min_curvature * a * a.transpose() + k.max_curvature * b * b.transpose();
}

// Surfaces F = 0 with F growing outwards: the derivative of the unit normal is the curvature tensor, convex positive.
struct Surface
{
  std::string name;
  std::function<Shape(int)> shape;
  std::function<Vec(const Vec&)> gradient;
  std::function<Mat(const Vec&)> hessian;
  std::function<bool(const Vec&)> is_inside = [](const Vec&) { return true; };

  Mat tensor(const Vec& p) const
  {
    const Vec g = gradient(p), n = g.normalized();
    const Mat projector = Mat::Identity() - n * n.transpose();
    return projector * hessian(p) * projector / g.norm();
  }
};

Surface ellipsoid_surface(const std::string& name, const Vec& axes)
{
  const Vec d = axes.cwiseProduct(axes).cwiseInverse();
  return {name, [axes](int n) { return ellipsoid(n, axes, 0.15); },
          [d](const Vec& p) { return Vec(2 * d.cwiseProduct(p)); },
          [d](const Vec&) { return Mat((2 * d).asDiagonal()); }};
}

// z = h(x, y) over [-1,1] x [-1,1], with the derivatives h_x, h_y, h_xx, h_xy, h_yy
Surface graph(const std::string& name, const std::function<double(double, double)>& h,
              const std::function<std::array<double, 5>(double, double)>& d)
{
  Surface s;
  s.name = name;
  s.shape = [h](int n) {
    return jittered_square(2 * n, 0.15).mapped([&](const Vec& p) {
      const double x = 2 * p.x() - 1, y = 2 * p.y() - 1;
      return Vec(x, y, h(x, y));
    });
  };
  s.gradient = [d](const Vec& p) { return Vec(-d(p.x(), p.y())[0], -d(p.x(), p.y())[1], 1); };
  s.hessian = [d](const Vec& p) {
    const auto a = d(p.x(), p.y());
    Mat m;
    m << -a[2], -a[3], 0, -a[3], -a[4], 0, 0, 0, 0;
    return m;
  };
  s.is_inside = [](const Vec& p) { return std::abs(p.x()) < 0.7 && std::abs(p.y()) < 0.7; };
  return s;
}

std::vector<Surface> surfaces()
{
  Surface cylinder;
  cylinder.name = "cylinder";
  cylinder.shape = [](int n) {
    return grid(
      4 * n, 2 * n, [](double u, double v) { return Vec(std::cos(2 * pi * u), std::sin(2 * pi * u), 3 * v); }, true);
  };
  cylinder.gradient = [](const Vec& p) { return Vec(2 * p.x(), 2 * p.y(), 0); };
  cylinder.hessian = [](const Vec&) { return Mat(Vec(2, 2, 0).asDiagonal()); };
  cylinder.is_inside = [](const Vec& p) { return p.z() > 0.8 && p.z() < 2.2; };

  const double big = 1, small = 0.4; // F = (hypot(x, y) - big)^2 + z^2 - small^2
  Surface torus;
  torus.name = "torus";
  torus.shape = [=](int n) {
    return grid(6 * n, 3 * n, [=](double u, double v) {
      const double r = big + small * std::cos(2 * pi * v);
      return Vec(r * std::cos(2 * pi * u), r * std::sin(2 * pi * u), small * std::sin(2 * pi * v));
    }, true, true);
  };
  torus.gradient = [=](const Vec& p) {
    const double r = p.head<2>().norm();
    return Vec(2 * (r - big) * p.x() / r, 2 * (r - big) * p.y() / r, 2 * p.z());
  };
  torus.hessian = [=](const Vec& p) {
    const double r = p.head<2>().norm();
    const Vec e(p.x() / r, p.y() / r, 0), t(-e.y(), e.x(), 0);
    return Mat(2 * e * e.transpose() + 2 * (r - big) / r * t * t.transpose()
               + 2 * Vec::UnitZ() * Vec::UnitZ().transpose());
  };

  return {ellipsoid_surface("sphere", Vec(1, 1, 1)),
          cylinder,
          torus,
          ellipsoid_surface("ellipsoid", Vec(1, 0.8, 0.6)),
          graph(
            "saddle", [](double x, double y) { return (x * x - y * y) / 2; },
            [](double x, double y) {
              return std::array<double, 5>{{x, -y, 1, 0, -1}};
            }),
          graph(
            "monkey saddle", [](double x, double y) { return (x * x * x - 3 * x * y * y) / 3; },
            [](double x, double y) {
              return std::array<double, 5>{{x * x - y * y, -2 * x * y, 2 * x, -2 * y, -2 * x}};
            })};
}

template <class Tag>
std::vector<Curvature> curvatures(const Mesh& mesh, int degree, double presmoothing = 0)
{
  Mesh copy = mesh;
  auto map = copy.add_property_map<Vertex, Curvature>("v:k").first;
  GDP_CHECK(GDP::estimate_curvatures(mesh, map, GDP::parameters::jet_degree(degree).presmoothing_weight(presmoothing)
                                                  .concurrency_tag(Tag())) == GDP::OK);
  std::vector<Curvature> result;
  for(Vertex v : mesh.vertices())
    result.push_back(map[v]);
  return result;
}

// The largest error of the tensor, and of the directions where they are well defined, relative to the largest
// curvature.
struct Errors
{
  double tensor = 0, direction = 0;
};

Errors errors(const Surface& surface, const Shape& shape, double scale, const std::vector<Curvature>& found)
{
  Errors result;
  double largest = 0;
  for(const Vec& p : shape.points)
    if(surface.is_inside(p))
      largest = (std::max)(largest, surface.tensor(p).norm());
  for(std::size_t v = 0; v < found.size(); ++v)
  {
    const Vec p = shape.points[v], a = vec(found[v].min_direction), b = vec(found[v].max_direction);
    GDP_CHECK(found[v].min_curvature <= found[v].max_curvature);
    GDP_CHECK_NEAR(a.norm(), 1, 1e-12);
    GDP_CHECK_NEAR(b.norm(), 1, 1e-12);
    GDP_CHECK_NEAR(a.dot(b), 0, 1e-12);
    if(!surface.is_inside(p))
      continue;
    const Mat exact = surface.tensor(p);
    result.tensor = (std::max)(result.tensor, (scale * tensor(found[v]) - exact).norm() / largest);
    const Vec n = surface.gradient(p).normalized();
    const Eigen::SelfAdjointEigenSolver<Mat> eigen(exact + 100 * n * n.transpose());
    if(eigen.eigenvalues()[1] - eigen.eigenvalues()[0] > 0.3 * largest)
      result.direction = (std::max)({result.direction, 1 - std::abs(a.dot(eigen.eigenvectors().col(0))),
                                     1 - std::abs(b.dot(eigen.eigenvectors().col(1)))});
  }
  return result;
}

void test_convergence()
{
  for(const Surface& surface : surfaces())
    for(int degree : {2, 4})
    {
      double error[3];
      for(int i = 0; i < 3; ++i)
      {
        const Shape shape = surface.shape(8 << i);
        Errors e;
        for(double scale : {1e-3, 1., 1e3, 1e6})
        {
          if(i == 2 && scale != 1e-3)
            continue;
          e = errors(surface, shape, scale,
                     curvatures<CGAL::Parallel_if_available_tag>(mesh_of(shape.scaled(scale)), degree));
          if(scale == 1e-3)
            error[i] = e.tensor;
          GDP_CHECK_NEAR(e.tensor, error[i], 1e-7); // no scale is special
        }
        if(i == 2)
          GDP_CHECK(e.direction < 0.01);
      }
      const double order = std::log2(error[0] / error[2]) / 2;
      std::cout << surface.name << ", degree " << degree << ": largest error " << error[0] << " " << error[1] << " "
                << error[2] << ", order " << order << std::endl;
      GDP_CHECK(error[2] < (degree == 2 ? 0.08 : 0.02));
      GDP_CHECK(order > (degree == 2 ? 0.8 : 1.8) || error[2] < 1e-6);
    }
}

void test_concurrency()
{
  const Mesh mesh = mesh_of(ellipsoid(24, Vec(1, 0.8, 0.6)).noisy(0.01));
  for(int degree : {2, 3})
  {
    const auto a = curvatures<CGAL::Sequential_tag>(mesh, degree, 1e-3);
    for(int run = 0; run < 3; ++run)
    {
      const auto b = curvatures<CGAL::Parallel_if_available_tag>(mesh, degree, 1e-3);
      for(std::size_t v = 0; v < a.size(); ++v)
      {
        GDP_CHECK(same_bits(a[v].min_curvature, b[v].min_curvature)
                  && same_bits(a[v].max_curvature, b[v].max_curvature));
        for(int i = 0; i < 3; ++i)
          GDP_CHECK(same_bits(a[v].min_direction[i], b[v].min_direction[i])
                    && same_bits(a[v].max_direction[i], b[v].max_direction[i]));
      }
    }
  }
  Mesh copy = mesh;
  auto map = copy.add_property_map<Vertex, Curvature>("v:k", Curvature{17, 17, Vector(0, 0, 0), Vector(0, 0, 0)}).first;
  for(int degree : {-1, 0, 1, 5})
    GDP_CHECK(
      GDP::estimate_curvatures(
        mesh, map, GDP::parameters::jet_degree(degree).presmoothing_weight(0.).concurrency_tag(CGAL::Sequential_tag()))
      == GDP::ERROR_INVALID_PARAMETER);
  GDP_CHECK(
    GDP::estimate_curvatures(
      mesh, map, GDP::parameters::jet_degree(2).presmoothing_weight(-1.).concurrency_tag(CGAL::Sequential_tag()))
    == GDP::ERROR_INVALID_WEIGHT);
  for(Vertex v : mesh.vertices())
    GDP_CHECK(map[v].min_curvature == 17);
}

// ---- metrics

// A mesh with a curvature for every vertex and a metric for every face.
struct With_metric
{
  Mesh mesh;
  Mesh::Property_map<Vertex, Curvature> curvature;
  Mesh::Property_map<Face, GDP::Triangle_metric> metric, embedding;

  explicit With_metric(const Shape& shape)
    : mesh(mesh_of(shape)), curvature(mesh.add_property_map<Vertex, Curvature>("v:k").first),
      metric(mesh.add_property_map<Face, GDP::Triangle_metric>("f:g").first),
      embedding(mesh.add_property_map<Face, GDP::Triangle_metric>("f:e").first)
  {
    GDP_CHECK(GDP::embedding_metric(mesh, embedding) == GDP::OK);
  }

  GDP::Error_code run(Kind kind, double weight, bool area_normalization = false)
  {
    return GDP::curvature_metric(mesh, metric,
                                 GDP::parameters::vertex_curvature_map(curvature)
                                   .curvature_metric_kind(kind)
                                   .curvature_weight(weight)
                                   .area_normalization(area_normalization));
  }

  template <class Functor>
  GDP::Error_code run_functor(const Functor& functor)
  {
    return GDP::curvature_metric(mesh, metric,
                                 GDP::parameters::vertex_curvature_map(curvature).curvature_metric_kind(functor));
  }

  // J^T (s1 d1 d1^T + s2 d2 d2^T) J
  void check(double s1, const Vec& d1, double s2, const Vec& d2, double tolerance) const
  {
    const Mat s = s1 * d1 * d1.transpose() + s2 * d2 * d2.transpose();
    for(Face f : mesh.faces())
    {
      const auto c = corners(mesh, f);
      const Vec t1 = vec(mesh.point(c[1])) - vec(mesh.point(c[0])), t2 = vec(mesh.point(c[2])) - vec(mesh.point(c[0]));
      const double size = embedding[f].max_squared_length() * (std::max)(s1, s2);
      GDP_CHECK_NEAR(metric[f].g11() / size, t1.dot(s * t1) / size, tolerance);
      GDP_CHECK_NEAR(metric[f].g12() / size, t1.dot(s * t2) / size, tolerance);
      GDP_CHECK_NEAR(metric[f].g22() / size, t2.dot(s * t2) / size, tolerance);
      GDP_CHECK_NEAR(metric[f].area() / size, std::sqrt(s1 * s2) * area_vector(mesh, f).norm() / size, tolerance);
    }
  }
};

struct Stretch
{
  std::pair<double, double> operator()(double k1, double k2) const { return {2 + k1 * k1, 5 - k2}; }
};
struct Different_stretches
{
  std::pair<double, double> operator()(double, double) const { return {1., 4.}; }
};
struct Bad_stretch
{
  std::pair<double, double> operator()(double k1, double) const { return {k1, 1.}; }
};

void test_embedding()
{
  With_metric m(sphere(5));
  m.metric = m.embedding;
  for(Face f : m.mesh.faces())
  {
    const auto c = corners(m.mesh, f);
    const Vec t1 = vec(m.mesh.point(c[1])) - vec(m.mesh.point(c[0])),
              t2 = vec(m.mesh.point(c[2])) - vec(m.mesh.point(c[0]));
    GDP_CHECK_NEAR(m.embedding[f].g11(), t1.dot(t1), 1e-14);
    GDP_CHECK_NEAR(m.embedding[f].g12(), t1.dot(t2), 1e-14);
    GDP_CHECK_NEAR(m.embedding[f].g22(), t2.dot(t2), 1e-14);
    GDP_CHECK_NEAR(m.embedding[f].area(), area_vector(m.mesh, f).norm(), 1e-14);
  }
}

// A constant curvature on a plane: the table of the kinds.
void test_kinds()
{
  for(double size : {1e-3, 1., 1e6})
  {
    With_metric m(jittered_square(8).scaled(size));
    const double c = std::cos(0.4), s = std::sin(0.4), k1 = -2 / size, k2 = 3 / size;
    const Vec d1(c, s, 0), d2(-s, c, 0);
    Random random;
    for(Vertex v : m.mesh.vertices()) // a direction and its opposite are the same
      m.curvature[v] = {k1, k2, to_vector(random() < 0 ? d1 : Vec(-d1)), to_vector(random() < 0 ? d2 : Vec(-d2))};
    for(double weight : {0., 0.02, 1., 1e4})
      for(bool normalized : {false, true})
      {
        const double eps = weight * size * size, given = normalized ? weight : eps; // the square has area size^2
        const double a = 1 + eps * k1 * k1, b = 1 + eps * k2 * k2, both = 1 + eps * (k1 * k1 + k2 * k2);
        GDP_CHECK(m.run(Kind::EMBEDDING, given, normalized) == GDP::OK);
        m.check(1, d1, 1, d2, 1e-13);
        GDP_CHECK(m.run(Kind::EDGE_AWARE, given, normalized) == GDP::OK);
        m.check(both, d1, both, d2, 1e-13);
        GDP_CHECK(m.run(Kind::ANISOTROPIC, given, normalized) == GDP::OK);
        m.check(a, d1, b, d2, 1e-13);
        GDP_CHECK(m.run(Kind::PRESERVE_CONVEX, given, normalized) == GDP::OK);
        m.check(1, d1, b, d2, 1e-13);
        GDP_CHECK(m.run(Kind::PRESERVE_CONCAVE, given, normalized) == GDP::OK);
        m.check(a, d1, 1, d2, 1e-13);
      }
    GDP_CHECK(m.run(Kind::EDGE_AWARE, -1) == GDP::ERROR_INVALID_WEIGHT);
    GDP_CHECK(m.run(Kind::EDGE_AWARE, std::numeric_limits<double>::infinity()) == GDP::ERROR_INVALID_WEIGHT);
  }

  // a functor: curvatures in the unit of the mesh
  With_metric m(jittered_square(8).scaled(0.01));
  const Vec d1 = Vec::UnitX(), d2 = Vec::UnitY();
  for(Vertex v : m.mesh.vertices())
    m.curvature[v] = {-2, 3, to_vector(d1), to_vector(d2)};
  GDP_CHECK(m.run_functor(Stretch()) == GDP::OK);
  m.check(6, d1, 2, d2, 1e-13);
  GDP_CHECK(m.run_functor(Different_stretches()) == GDP::OK);
  m.check(1, d1, 4, d2, 1e-13);
  const GDP::Triangle_metric before = m.metric[Face(0)];
  GDP_CHECK(m.run_functor(Bad_stretch()) == GDP::ERROR_INVALID_METRIC); // -2 is no stretch
  GDP_CHECK(same_bits(before.g11(), m.metric[Face(0)].g11()));

  // an umbilic point has no directions: whatever they are, the metric is a multiple of the embedding's
  Random random;
  for(double k : {0., 2., -5.})
  {
    for(Vertex v : m.mesh.vertices())
    {
      const double angle = random.in(0, 2 * pi);
      m.curvature[v] = {k, k, Vector(std::cos(angle), std::sin(angle), 0),
                        Vector(-std::sin(angle), std::cos(angle), 0)};
    }
    GDP_CHECK(m.run(Kind::ANISOTROPIC, 0.5) == GDP::OK);
    m.check(1 + 0.5 * k * k, d1, 1 + 0.5 * k * k, d2, 1e-11);
    GDP_CHECK(m.run(Kind::PRESERVE_CONVEX, 0.5) == GDP::OK);
    m.check(k > 0 ? 1 + 0.5 * k * k : 1, d1, k > 0 ? 1 + 0.5 * k * k : 1, d2, 1e-11);
  }
  for(Vertex v : m.mesh.vertices())
    m.curvature[v] = {2, 2, Vector(1, 0, 0), Vector(0, 1, 0)};
  GDP_CHECK(m.run_functor(Different_stretches()) == GDP::OK);
  m.check(2, d1, 2, d2, 1e-12);
}

// Whatever the curvatures and the faces: every tensor is symmetric positive definite, or there is an error.
void test_definiteness()
{
  Shape shape = sphere(4).noisy(0.05);
  for(int i = 0; i < 30; i += 3) // needles, caps and points
    shape.points[i] = shape.points[i + 1] + 1e-9 * (i % 2) * Vec(1, 2, 3);
  With_metric m(shape);
  Random random;
  for(double size : {0., 1e-300, 1., 1e8, 1e150, 1e300})
    for(Kind kind : {Kind::EDGE_AWARE, Kind::ANISOTROPIC, Kind::PRESERVE_CONVEX, Kind::PRESERVE_CONCAVE})
      for(double weight : {1e-300, 0.02, 1e300})
      {
        for(Vertex v : m.mesh.vertices())
        {
          const double a = size * random(), b = size * random(), x = random(), y = random(), z = random();
          const Vec d = Vec(x, y, z).normalized();
          m.curvature[v] = {(std::min)(a, b), (std::max)(a, b), to_vector(d), to_vector(d.unitOrthogonal())};
        }
        GDP_CHECK(m.run(kind, weight) == GDP::OK);
        for(Face f : m.mesh.faces())
          if(m.embedding[f].is_valid())
            GDP_CHECK(m.metric[f].is_valid());
      }
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for(double bad : {nan, inf})
    for(int member = 0; member < 4; ++member)
    {
      for(Vertex v : m.mesh.vertices())
        m.curvature[v] = {1, 2, Vector(1, 0, 0), Vector(0, 1, 0)};
      Curvature& k = m.curvature[Vertex(9)];
      if(member == 0) k.min_curvature = bad;
      if(member == 1) k.max_curvature = bad;
      if(member == 2) k.min_direction = Vector(bad, 0, 0);
      if(member == 3) k.max_direction = Vector(0, 0, bad);
      GDP_CHECK(m.run(Kind::EDGE_AWARE, 0.02) == GDP::ERROR_INVALID_TARGET);
    }
}

// The part of the area that a metric adds, which is eps (k1^2 + k2^2) for the edge-aware one: its relative error on a
// unit sphere.
double error_on_sphere(const With_metric& m, double eps)
{
  double sum = 0;
  for(Face f : m.mesh.faces())
  {
    const double found = std::sqrt((std::max)(0., m.metric[f].area() / m.embedding[f].area() - 1) / eps);
    sum += (found / std::sqrt(2.) - 1) * (found / std::sqrt(2.) - 1);
  }
  return std::sqrt(sum / m.mesh.number_of_faces());
}

void test_estimators_and_maps()
{
  With_metric exact(sphere(16));
  for(Vertex v : exact.mesh.vertices())
  {
    const Vec p = vec(exact.mesh.point(v)), d = p.unitOrthogonal();
    exact.curvature[v] = {1, 1, to_vector(d), to_vector(p.cross(d))};
  }
  GDP_CHECK(exact.run(Kind::EDGE_AWARE, 0.5) == GDP::OK);
  GDP_CHECK(error_on_sphere(exact, 0.5) < 0.01);
  GDP_CHECK(exact.run(Kind::PRESERVE_CONVEX, 0.5) == GDP::OK);
  GDP_CHECK_NEAR(exact.metric[Face(3)].area() / exact.embedding[Face(3)].area(), 1.5, 0.02);
  GDP_CHECK(exact.run(Kind::PRESERVE_CONCAVE, 0.5) == GDP::OK);
  GDP_CHECK_NEAR(exact.metric[Face(3)].area() / exact.embedding[Face(3)].area(), 1, 1e-12);

  for(double noise : {0., 0.002, 0.01})
  {
    With_metric m(sphere(16).noisy(noise));
    double error[2];
    for(int i : {0, 1})
    {
      GDP_CHECK(GDP::curvature_metric(
                  m.mesh, m.metric,
                  GDP::parameters::curvature_weight(0.5)
                    .area_normalization(false)
                    .presmoothing_weight(noise == 0 ? 0. : 1e-2)
                    .curvature_estimator(i == 0 ? GDP::Curvature_estimator::JETS : GDP::Curvature_estimator::NORMALS))
                == GDP::OK);
      error[i] = error_on_sphere(m, 0.5);
      // averaged normals of an irregular mesh are off by themselves
      GDP_CHECK(error[i] < (i == 0 ? 0.03 : 0.25) + 5 * noise);
    }
    std::cout << "sphere with noise " << noise << ": error of jets " << error[0] << ", of normals " << error[1]
              << std::endl;
  }

#if CGAL_VERSION_NR >= 1060000000
  // curvatures of another package, with its own value type
  namespace PMP = CGAL::Polygon_mesh_processing;
  typedef PMP::Principal_curvatures_and_directions<Kernel> Pmp_curvature;
  auto map = exact.mesh.add_property_map<Vertex, Pmp_curvature>("v:pmp").first;
  PMP::interpolated_corrected_curvatures(
    exact.mesh, CGAL::parameters::vertex_principal_curvatures_and_directions_map(map).ball_radius(0.3));
  GDP_CHECK(
    GDP::curvature_metric(exact.mesh, exact.metric,
                          GDP::parameters::vertex_curvature_map(map).curvature_weight(0.5).area_normalization(false))
    == GDP::OK);
  const double error = error_on_sphere(exact, 0.5);
  std::cout << "curvatures of Polygon_mesh_processing: error " << error << std::endl;
  GDP_CHECK(error < 0.1);
  for(Vertex v : exact.mesh.vertices()) // the same sign: convex positive
    GDP_CHECK(map[v].min_curvature > 0.5);
#endif
}

int main()
{
  test_convergence();
  test_concurrency();
  test_embedding();
  test_kinds();
  test_definiteness();
  test_estimators_and_maps();
  return GDP_TEST_RESULT();
}
