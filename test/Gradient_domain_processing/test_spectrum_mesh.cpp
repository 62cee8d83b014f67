// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// spectrum() and filter_spectrum() on meshes.

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/Conjugate_gradient_solver_traits.h>
#include <CGAL/Gradient_domain_processing/curvature_metric.h>
#include <CGAL/Gradient_domain_processing/deformation_matrices.h>
#include <CGAL/Gradient_domain_processing/filter_spectrum.h>
#include <CGAL/Gradient_domain_processing/hessian_matrix.h>
#include <CGAL/Gradient_domain_processing/mass_matrix.h>
#include <CGAL/Gradient_domain_processing/spectrum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <set>
#include <string>
#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;

namespace {

typedef GDP::Spectral_filter Filter;
typedef Mesh::Property_map<Vertex, double> Signal_map;

Signal_map signal_of(Mesh& mesh, const std::string& name, const std::function<double(const Point&)>& f)
{
  Signal_map map = mesh.add_property_map<Vertex, double>(name, 0).first;
  for(Vertex v : mesh.vertices())
    map[v] = f(mesh.point(v));
  return map;
}

double distance(const Mesh& mesh, Signal_map a, const std::function<double(Vertex)>& b)
{
  double most = 0;
  for(Vertex v : mesh.vertices())
    most = (std::max)(most, std::abs(a[v] - b(v)));
  return most;
}

// On a sphere of radius 10 harmonics of degree l have the eigenvalue l (l + 1) / 100, up to the discretization.
void test_bands()
{
  Mesh mesh = mesh_of(sphere(24).scaled(10));
  const Signal_map one = signal_of(mesh, "v:one", [](const Point&) { return 3; });
  const Signal_map first = signal_of(mesh, "v:first", [](const Point& p) { return p.z() / 10; });
  const Signal_map second = signal_of(mesh, "v:second", [](const Point& p) { return p.x() * p.y() / 100; });
  const Signal_map sum = signal_of(mesh, "v:sum", [](const Point& p) { return 3 + p.z() / 10 + p.x() * p.y() / 100; });
  const Signal_map out = signal_of(mesh, "v:out", [](const Point&) { return 0; });
  const double pass = 2 * pi / std::sqrt(0.04), other = 2 * pi / std::sqrt(0.005);
  for(int order : {1, 3, 4})
    for(int kind = 0; kind < 4; ++kind)
    {
      const Filter filter = kind == 0 ? Filter::low_pass(pass, order) : kind == 1 ? Filter::high_pass(pass, order)
                          : kind == 2 ? Filter::band_pass(pass, other, order) : Filter::band_stop(other, pass, order);
      GDP_CHECK(GDP::filter_spectrum(mesh, sum, out, filter) == GDP::ok);
      GDP_CHECK_NEAR(distance(mesh, out, [&](Vertex v) {
        return filter(0) * one[v] + filter(0.02) * first[v] + filter(0.06) * second[v];
      }), 0, 0.01);
      // what is constant is kept or removed altogether, whatever the scale
      GDP_CHECK(GDP::filter_spectrum(mesh, one, out, filter) == GDP::ok);
      GDP_CHECK_NEAR(distance(mesh, out, [&](Vertex) { return kind == 0 || kind == 3 ? 3. : 0.; }), 0, 1e-7);
      // a functor, by harmonics: the rest of this signal is small
      const auto function = [&](double mu) { return filter(mu); };
      const Signal_map by_harmonics = signal_of(mesh, "v:harmonics", [](const Point&) { return 0; });
      GDP_CHECK(GDP::filter_spectrum(mesh, sum, by_harmonics, function, GDP::parameters::number_of_harmonics(25))
                == GDP::ok);
      GDP_CHECK(GDP::filter_spectrum(mesh, sum, out, filter) == GDP::ok);
      GDP_CHECK_NEAR(distance(mesh, out, [&](Vertex v) { return by_harmonics[v]; }), 0, 0.01);
    }
}

// Steps with damped coefficients: one and zero but for ripples, steeper than a half at the cut-off; what is stated is
// what happens.
void test_windows()
{
  Mesh mesh = mesh_of(sphere(24).scaled(10));
  const Signal_map second = signal_of(mesh, "v:second", [](const Point& p) { return p.x() * p.y() / 100; });
  const Signal_map out = signal_of(mesh, "v:out", [](const Point&) { return 0; });
  const double ripple[4] = {0.003, 0.008, 0.001, 0.0001};
  const GDP::Spectral_window windows[4] = {GDP::Spectral_window::HAMMING, GDP::Spectral_window::HANN,
                                           GDP::Spectral_window::BLACKMAN, GDP::Spectral_window::NUTTALL};
  for(int i = 0; i < 4; ++i)
  {
    const Filter filter = Filter::windowed_low_pass(25, 40, windows[i]);
    GDP_CHECK(filter.degree() == 40 && filter.error_bound() == 0);
    GDP_CHECK_NEAR(filter(0), 1, 1e-14);
    GDP_CHECK_NEAR(filter(Filter::eigenvalue(25)), 0.5, ripple[i]);
    for(double factor = 1.35; factor < 1000; factor *= 1.01)
    {
      GDP_CHECK_NEAR(filter(Filter::eigenvalue(25 * factor)), 1, ripple[i]);
      GDP_CHECK_NEAR(filter(Filter::eigenvalue(25 / factor)), 0, ripple[i]);
    }
    const Filter others[2] = {filter, filter.without(Filter::windowed_low_pass(40, 40, windows[i])).complement()};
    for(const Filter& other : others)
    {
      GDP_CHECK(GDP::filter_spectrum(mesh, second, out, other) == GDP::ok);
      GDP_CHECK_NEAR(distance(mesh, out, [&](Vertex v) { return other(0.06) * second[v]; }), 0, 0.02);
    }
  }
}

struct Notices : GDP::Default_visitor
{
  std::shared_ptr<int> count = std::make_shared<int>(0);
  void notice(const std::string&) { ++*count; }
};

// A solver that does not converge gives way to one that does, and the visitor is told.
void test_no_convergence()
{
  Mesh mesh = mesh_of(sphere(40));
  const Signal_map in = signal_of(mesh, "v:in", [](const Point& p) { return std::sin(9 * p.x()) + p.y(); });
  const Signal_map expected = signal_of(mesh, "v:expected", [](const Point&) { return 0; });
  const Signal_map out = signal_of(mesh, "v:out", [](const Point&) { return 0; });
  const auto function = [](double mu) { return 1 / (1 + mu / 40); };
  for(const Filter& filter : {Filter::low_pass(0.7), Filter::approximation(function, 1)})
  {
    const Notices notices;
    GDP_CHECK(GDP::filter_spectrum(mesh, in, expected, filter) == GDP::ok);
    GDP_CHECK(GDP::filter_spectrum(mesh, in, out, filter, GDP::parameters::visitor(notices)
                .sparse_linear_solver(GDP::Conjugate_gradient_solver_traits<>(1e-13, 1)))
              == GDP::ok);
    GDP_CHECK(*notices.count == 1);
    GDP_CHECK_NEAR(distance(mesh, out, [&](Vertex v) { return expected[v]; }), 0, 1e-12);
  }
}

// Constrained vertices and what is outside of a region keep their values; a function that is harmonic between them is
// kept as it is.
void test_constrained_bands()
{
  Mesh mesh = mesh_of(grid(16, 16, [](double u, double v) { return Vec(u, v, 0); }));
  const Signal_map linear = signal_of(mesh, "v:linear", [](const Point& p) { return 2 * p.x() - p.y(); });
  const Signal_map rough = signal_of(mesh, "v:rough", [](const Point& p) { return std::sin(40 * p.x() + 30 * p.y()); });
  const Signal_map out = signal_of(mesh, "v:out", [](const Point&) { return 0; });
  const auto fixed = GDP::parameters::border_condition(GDP::Border_condition::FIXED);
  const Filter filter = Filter::low_pass(0.5);
  GDP_CHECK(GDP::filter_spectrum(mesh, linear, out, filter, fixed) == GDP::ok);
  GDP_CHECK_NEAR(distance(mesh, out, [&](Vertex v) { return linear[v]; }), 0, 1e-7);
  GDP_CHECK(GDP::filter_spectrum(mesh, rough, out, filter, fixed) == GDP::ok);
  double inside = 0;
  for(Vertex v : mesh.vertices())
    if(CGAL::is_border(v, mesh))
      GDP_CHECK(out[v] == rough[v]);
    else
      inside = (std::max)(inside, std::abs(out[v] - rough[v]));
  GDP_CHECK(inside > 0.1);
  // a border that is a curve of its own elsewhere counts as fixed, beside a constraint too
  const Signal_map along = signal_of(mesh, "v:along", [](const Point&) { return 0; });
  const auto along_border = GDP::parameters::border_condition(GDP::Border_condition::ALONG_BORDER);
  GDP_CHECK(GDP::filter_spectrum(mesh, rough, along, filter, along_border) == GDP::ok);
  GDP_CHECK_NEAR(distance(mesh, along, [&](Vertex v) { return out[v]; }), 0, 0);

  const std::vector<Face> region(mesh.faces().begin(), mesh.faces().begin() + 200);
  const Signal_map in_region = signal_of(mesh, "v:in_region", [](const Point&) { return -7; });
  GDP_CHECK(GDP::filter_spectrum(region, mesh, rough, in_region, filter) == GDP::ok);
  std::set<Vertex> inner(mesh.vertices().begin(), mesh.vertices().end());
  for(Face f : mesh.faces())
    if(int(f) >= 200)
      for(Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
        inner.erase(v);
  GDP_CHECK(!inner.empty());
  for(Vertex v : inner)
    GDP_CHECK(in_region[v] != -7 && in_region[v] != rough[v]);
}

// Moved, turned and scaled, as a soup in another order, cut open and welded, or of quads, it is the same surface.
void test_equivariance()
{
  Mesh mesh = mesh_of(grid(14, 14, [](double u, double v) { return Vec(u, 1.2 * v, 0.2 * u * v); }));
  const Signal_map in =
    signal_of(mesh, "v:in", [](const Point& p) { return std::sin(9 * p.x()) + std::cos(11 * p.y() * p.x()); });
  const Signal_map out = signal_of(mesh, "v:out", [](const Point&) { return 0; });
  const double wavelength = 0.4;
  GDP_CHECK(GDP::filter_spectrum(mesh, in, out, Filter::low_pass(wavelength)) == GDP::ok);

  std::vector<std::size_t> order(mesh.number_of_vertices());
  for(std::size_t i = 0; i < order.size(); ++i)
    order[i] = (i * 101 + 7) % order.size();
  std::vector<Point> points(order.size());
  std::vector<double> values(order.size());
  for(Vertex v : mesh.vertices())
  {
    const Point& p = mesh.point(v);
    points[order[v]] = Point(8 * p.y() + 3, -8 * p.x() - 5, 8 * p.z());
    values[order[v]] = in[v];
  }
  std::vector<std::array<std::size_t, 3> > triangles;
  for(Face f : mesh.faces())
  {
    std::array<std::size_t, 3> t{};
    std::size_t i = 0;
    for(Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      t[i++] = order[v];
    triangles.push_back(t);
  }
  const auto map = CGAL::make_property_map(values);
  GDP_CHECK(GDP::filter_spectrum(points, triangles, map, map, Filter::low_pass(8 * wavelength)) == GDP::ok);
  GDP_CHECK_NEAR(distance(mesh, out, [&](Vertex v) { return values[order[v]]; }), 0, 1e-9);

  // every triangle for itself, with a signal that differs between them by a constant
  std::vector<Point> apart;
  std::vector<double> of_corners;
  std::vector<std::array<std::size_t, 3> > loose;
  for(Face f : mesh.faces())
  {
    loose.push_back({apart.size(), apart.size() + 1, apart.size() + 2});
    for(Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
    {
      apart.push_back(mesh.point(v));
      of_corners.push_back(in[v]);
    }
  }
  const auto corners = CGAL::make_property_map(of_corners);
  GDP_CHECK(GDP::filter_spectrum(apart, loose, corners, corners, Filter::low_pass(wavelength),
                                 GDP::parameters::weld_tolerance(0.))
            == GDP::ok);
  std::size_t corner = 0;
  double most = 0;
  for(Face f : mesh.faces())
    for(Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      most = (std::max)(most, std::abs(of_corners[corner++] - out[v]));
  GDP_CHECK_NEAR(most, 0, 1e-9);

  // quads: what is constant stays, a wave at the cut-off is halved
  std::vector<Point> grid_points;
  std::vector<double> constant, wave;
  std::vector<std::array<std::size_t, 4> > quads;
  for(int i = 0; i <= 20; ++i)
    for(int j = 0; j <= 20; ++j)
    {
      grid_points.emplace_back(i / 20., j / 20., 0);
      constant.push_back(5);
      wave.push_back(std::cos(2 * pi * i / 20.)); // of wavelength 1, and level at the border
    }
  for(std::size_t i = 0; i < 20; ++i)
    for(std::size_t j = 0; j < 20; ++j)
      quads.push_back({{21 * i + j, 21 * i + 21 + j, 21 * i + 22 + j, 21 * i + 1 + j}});
  const auto of_constant = CGAL::make_property_map(constant), of_wave = CGAL::make_property_map(wave);
  GDP_CHECK(GDP::filter_spectrum(grid_points, quads, of_constant, of_constant, Filter::low_pass(0.5)) == GDP::ok);
  GDP_CHECK(GDP::filter_spectrum(grid_points, quads, of_wave, of_wave, Filter::low_pass(1)) == GDP::ok);
  for(std::size_t i = 0; i < wave.size(); ++i)
  {
    GDP_CHECK_NEAR(constant[i], 5, 1e-7);
    GDP_CHECK_NEAR(wave[i], 0.5 * std::cos(2 * pi * double(i / 21) / 20), 0.015);
  }
}

// Between, at and beyond the cut-offs, named in any order.
void test_transfer_functions()
{
  const double low = Filter::eigenvalue(2), high = Filter::eigenvalue(0.5); // a factor of 16
  GDP_CHECK_NEAR(low, pi * pi, 1e-12);
  for(bool is_reversed : {false, true})
  {
    const Filter pass = is_reversed ? Filter::band_pass(2, 0.5, 6) : Filter::band_pass(0.5, 2, 6);
    const Filter stop = is_reversed ? Filter::band_stop(2, 0.5, 6) : Filter::band_stop(0.5, 2, 6);
    for(double mu : {0., low / 4, low, 4 * low, high, 4 * high})
    {
      GDP_CHECK_NEAR(pass(mu), mu == 4 * low ? 1 : mu == low || mu == high ? 0.5 : 0, 1e-3);
      GDP_CHECK_NEAR(stop(mu), 1 - pass(mu), 1e-12);
    }
  }
}

// The two eigenvalues of degree three that are nearest to a shift, in units of the mesh.
void test_shift()
{
  Mesh mesh = mesh_of(sphere(16).scaled(10));
  Eigen::VectorXd lowest, values;
  Eigen::MatrixXd harmonics;
  GDP_CHECK(GDP::spectrum(mesh, 20, lowest, harmonics) == GDP::ok);
  GDP_CHECK(GDP::spectrum(mesh, 7, values, harmonics, GDP::parameters::spectral_shift(0.12)) == GDP::ok);
  for(int j = 0; j < 7; ++j)
    GDP_CHECK_NEAR(values[j], lowest[9 + j], 1e-10);
  GDP_CHECK(GDP::spectrum(mesh, 7, values, harmonics, GDP::parameters::spectral_shift(HUGE_VAL))
            == GDP::error_invalid_parameter);
}

// A metric that stretches one half of a square: with areas of its own it is a longer square; with those of the
// embedding, a conductance (omega tan(omega / 2) + omega / 2 tan(omega) = 0 for waves across).
void test_embedding_measure()
{
  Mesh mesh = mesh_of(grid(32, 8, [](double u, double v) { return Vec(u, 0.25 * v, 0); }));
  auto metrics = mesh.add_property_map<Face, GDP::Triangle_metric>("f:metric").first;
  for(Face f : mesh.faces())
  {
    const auto h = mesh.halfedge(f); // a metric's corners begin with its source
    std::vector<Vec> p;
    for(Vertex v : {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))})
      p.emplace_back(mesh.point(v).x(), mesh.point(v).y(), 0);
    const double stretch = (p[0] + p[1] + p[2]).x() < 1.5 ? 1 : 4;
    metrics[f] = GDP::Triangle_metric::stretched(p[0], p[1], p[2], stretch, Vec::UnitX(), 1, Vec::UnitY());
  }
  Eigen::VectorXd values;
  Eigen::MatrixXd harmonics;
  GDP_CHECK(GDP::spectrum(mesh, 2, values, harmonics, GDP::parameters::face_metric_map(metrics)) == GDP::ok);
  GDP_CHECK_NEAR(values[1] / std::pow(pi / 1.5, 2), 1, 0.01);
  GDP_CHECK(GDP::spectrum(mesh, 2, values, harmonics,
                          GDP::parameters::face_metric_map(metrics).embedding_measure(true))
            == GDP::ok);
  GDP_CHECK_NEAR(values[1] / std::pow(2 * std::atan(std::sqrt(2.)), 2), 1, 0.01);
  GDP_CHECK_NEAR(harmonics.col(0).cwiseAbs().maxCoeff(), 2, 1e-9); // one over the root of the area
}

// A region is what is left when all with a face outside is constrained, on a mesh and on a soup.
void test_region()
{
  Mesh mesh = mesh_of(grid(16, 12, [](double u, double v) { return Vec(u, v, 0.2 * u * u); }));
  auto is_outside = mesh.add_property_map<Vertex, bool>("v:outside", false).first;
  std::vector<Face> region;
  std::vector<std::size_t> indices;
  std::vector<std::array<std::size_t, 3> > triangles;
  std::vector<Point> points(mesh.number_of_vertices());
  for(Vertex v : mesh.vertices())
    points[v] = mesh.point(v);
  for(Face f : mesh.faces())
  {
    std::array<std::size_t, 3> t{};
    std::size_t i = 0;
    double x = 0;
    for(Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
    {
      x += mesh.point(v).x() / 3;
      t[i++] = v;
    }
    if(x < 0.6)
    {
      region.push_back(f);
      indices.push_back(triangles.size());
    }
    else
      for(Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
        is_outside[v] = true;
    triangles.push_back(t);
  }
  std::reverse(region.begin(), region.end());
  region.push_back(region.front()); // twice is once
  Eigen::VectorXd expected, values, of_soup;
  Eigen::MatrixXd harmonics;
  GDP_CHECK(GDP::spectrum(mesh, 9, expected, harmonics, GDP::parameters::vertex_is_constrained_map(is_outside))
            == GDP::ok);
  GDP_CHECK(GDP::spectrum(region, mesh, 9, values, harmonics) == GDP::ok && values.size() == 9);
  GDP_CHECK_NEAR((values - expected).cwiseAbs().maxCoeff(), 0, 1e-9);
  for(Vertex v : mesh.vertices())
    GDP_CHECK((harmonics.row(int(v)).norm() == 0) == is_outside[v]);
  GDP_CHECK(GDP::spectrum(indices, points, triangles, 9, of_soup, harmonics) == GDP::ok);
  GDP_CHECK_NEAR((of_soup - expected).cwiseAbs().maxCoeff(), 0, 1e-8);
  // with constraints of its own, one more
  auto is_constrained = mesh.add_property_map<Vertex, bool>("v:constrained", false).first;
  is_constrained[Vertex(3)] = true;
  GDP_CHECK(GDP::spectrum(region, mesh, 9, values, harmonics,
                          GDP::parameters::vertex_is_constrained_map(is_constrained)) == GDP::ok);
  GDP_CHECK(harmonics.row(3).isZero(0) != is_outside[Vertex(3)] && values[0] > expected[0]);
  region.push_back(Face(100000));
  indices.push_back(100000);
  GDP_CHECK(GDP::spectrum(region, mesh, 9, values, harmonics) == GDP::error_invalid_region);
  GDP_CHECK(GDP::spectrum(indices, points, triangles, 9, values, harmonics) == GDP::error_invalid_region);
}

// Masks are conductances and masses: of a half that conducts four times worse (see test_embedding_measure), of all, and
// of a part that alone is left, with a border of its own.
void test_masks()
{
  Mesh mesh = mesh_of(grid(32, 8, [](double u, double v) { return Vec(u, 0.25 * v, 0); }));
  auto alpha = mesh.add_property_map<Vertex, double>("v:alpha", 1).first;
  auto beta = mesh.add_property_map<Face, double>("f:beta", 1).first;
  std::vector<double> of_points(mesh.number_of_vertices(), 1), of_polygons;
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3> > triangles;
  for(Vertex v : mesh.vertices())
    points.push_back(mesh.point(v));
  const auto is_left_of = [&](double end, Face f) {
    double x = 0;
    for(Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      x += mesh.point(v).x() / 3;
    return x < end;
  };
  for(Face f : mesh.faces())
  {
    std::array<std::size_t, 3> t{};
    std::size_t i = 0;
    for(Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      t[i++] = v;
    triangles.push_back(t);
    beta[f] = is_left_of(0.5, f) ? 1 : 0.25;
    of_polygons.push_back(beta[f]);
  }
  Eigen::VectorXd plain, values, of_soup;
  Eigen::MatrixXd harmonics;
  const auto np = GDP::parameters::vertex_value_weight_map(alpha).face_gradient_weight_map(beta);
  GDP_CHECK(GDP::spectrum(mesh, 6, plain, harmonics) == GDP::ok);
  GDP_CHECK(GDP::spectrum(mesh, 6, values, harmonics, np) == GDP::ok);
  GDP_CHECK_NEAR(values[1] / std::pow(2 * std::atan(std::sqrt(2.)), 2), 1, 0.01);
  const auto of_map = [](std::vector<double>& x) { return CGAL::make_property_map(x); };
  GDP_CHECK(GDP::spectrum(points, triangles, 6, of_soup, harmonics,
                          GDP::parameters::vertex_value_weight_map(of_map(of_points))
                            .face_gradient_weight_map(of_map(of_polygons)))
            == GDP::ok);
  GDP_CHECK_NEAR((of_soup - values).cwiseAbs().maxCoeff(), 0, 1e-8);

  for(Vertex v : mesh.vertices())
    alpha[v] = 8;
  for(Face f : mesh.faces())
    beta[f] = 2;
  GDP_CHECK(GDP::spectrum(mesh, 6, values, harmonics, np) == GDP::ok);
  GDP_CHECK_NEAR((4 * values - plain).cwiseAbs().maxCoeff(), 0, 1e-8);

  for(Vertex v : mesh.vertices())
    alpha[v] = mesh.point(v).x() < 0.51;
  for(Face f : mesh.faces())
    beta[f] = is_left_of(0.53, f); // wherever values count
  GDP_CHECK(GDP::spectrum(mesh, 2, values, harmonics, np) == GDP::ok);
  GDP_CHECK_NEAR(values[0], 0, 1e-9);
  GDP_CHECK_NEAR(values[1] / (4 * pi * pi), 1, 0.1);
  for(Vertex v : mesh.vertices())
    GDP_CHECK((harmonics(int(v), 0) == 0) == (mesh.point(v).x() > 0.54));
  alpha[Vertex(7)] = -1;
  GDP_CHECK(GDP::spectrum(mesh, 2, values, harmonics, np) == GDP::error_invalid_weight);
  alpha[Vertex(7)] = 1;
  beta[Face(7)] = std::nan("");
  GDP_CHECK(GDP::spectrum(mesh, 2, values, harmonics, np) == GDP::error_invalid_weight);
}

// On a cylinder waves around it are slowed down, those along it are not: the spectrum sees the direction of curvature.
void test_curvature_direction()
{
  const double radius = 0.5, a = 3;
  Mesh mesh;
  const int n = 48, m = 24;
  std::vector<Vertex> ring;
  for(int j = 0; j <= m; ++j)
    for(int i = 0; i < n; ++i)
      ring.push_back(mesh.add_vertex(Point(radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n),
                                           pi / 2 * j / m)));
  for(int j = 0; j < m; ++j)
    for(int i = 0; i < n; ++i)
    {
      const auto at = [&](int k, int l) { return ring[std::size_t((j + l) * n + (i + k) % n)]; };
      mesh.add_face(at(0, 0), at(1, 0), at(1, 1));
      mesh.add_face(at(0, 0), at(1, 1), at(0, 1));
    }
  auto metrics = mesh.add_property_map<Face, GDP::Triangle_metric>("f:metric").first;
  const auto slowness = [&](double k1, double k2) {
    return std::make_pair(1 + a * std::abs(k1), 1 + a * std::abs(k2));
  };
  GDP_CHECK(GDP::curvature_metric(mesh, metrics, GDP::parameters::curvature_metric_kind(slowness)
              .presmoothing_weight(0)) == GDP::ok);
  Eigen::VectorXd values, plain;
  Eigen::MatrixXd harmonics;
  GDP_CHECK(GDP::spectrum(mesh, 6, plain, harmonics) == GDP::ok);
  GDP_CHECK(GDP::spectrum(mesh, 6, values, harmonics,
                          GDP::parameters::face_metric_map(metrics).embedding_measure(true))
            == GDP::ok);
  // along: 4 j^2; around: m^2 / radius^2, twice each, over 1 + a / radius
  const double of_plain[6] = {0, 4, 4, 4, 8, 8};
  const double around = 4 / (1 + a / radius);
  const double expected[6] = {0, around, around, 4 * around, 4 * around, 4};
  for(int j = 0; j < 6; ++j)
  {
    GDP_CHECK_NEAR(plain[j], of_plain[j], 0.06);
    GDP_CHECK_NEAR(values[j], expected[j], 0.15);
  }
}

// Modes of a shell: six rigid motions, then what costs energy; and of the bi-Laplacian of a sphere.
void test_spectra_of_matrices()
{
  Mesh mesh = mesh_of(sphere(8));
  mesh.add_vertex(Point(1, 2, 3)); // without a face
  Eigen::SparseMatrix<double> mass, shell, hessian;
  GDP_CHECK(GDP::mass_matrix(mesh, mass) == GDP::ok && GDP::shell_hessian_matrix(mesh, 1, 1, 1, shell) == GDP::ok
            && GDP::hessian_matrix(mesh, GDP::Hessian_kind::BILAPLACIAN, hessian) == GDP::ok);
  Eigen::SparseMatrix<double> mass_of_shell(3 * mass.rows(), 3 * mass.rows());
  std::vector<Eigen::Triplet<double> > entries;
  for(int j = 0; j < int(mass.cols()); ++j)
    for(Eigen::SparseMatrix<double>::InnerIterator it(mass, j); it; ++it)
      for(int k = 0; k < 3; ++k)
        entries.emplace_back(3 * int(it.row()) + k, 3 * j + k, it.value());
  mass_of_shell.setFromTriplets(entries.begin(), entries.end());

  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
  GDP_CHECK(GDP::spectrum(shell, mass_of_shell, 20, values, vectors) == GDP::ok);
  GDP_CHECK(values.size() == 20 && vectors.rows() == 3 * int(mass.rows()));
  for(int j = 0; j < 6; ++j)
    GDP_CHECK_NEAR(values[j], 0, 1e-9 * values[19]);
  GDP_CHECK(values[6] > 1e-3 * values[19]);
  const Eigen::MatrixXd residual = shell * vectors - mass_of_shell * vectors * values.asDiagonal();
  GDP_CHECK_NEAR(residual.cwiseAbs().maxCoeff(), 0, 1e-7 * values[19]);

  GDP_CHECK(GDP::spectrum(hessian, mass, 9, values, vectors) == GDP::ok);
  for(int j = 0; j < 9; ++j)
    GDP_CHECK_NEAR(values[j], j == 0 ? 0 : j < 4 ? 4 : 36, j < 4 ? 0.5 : 7);
  std::vector<char> is_constrained(std::size_t(mass.rows()), 0);
  is_constrained[3] = 1;
  GDP_CHECK(GDP::spectrum(hessian, mass, 2, values, vectors,
                          GDP::parameters::vertex_is_constrained_map(CGAL::make_property_map(is_constrained))
                            .spectral_shift(4))
            == GDP::ok);
  GDP_CHECK(vectors.row(3).isZero(0) && std::abs(values[0] - 4) < 0.5);
  GDP_CHECK(GDP::spectrum(hessian, shell, 2, values, vectors) == GDP::error_invalid_parameter);
}

void test_refusals()
{
  Mesh mesh = mesh_of(grid(4, 4, [](double u, double v) { return Vec(u, v, 0); }));
  const Signal_map out = signal_of(mesh, "v:out", [](const Point& p) { return p.x(); });
  const double infinity = HUGE_VAL, nan = std::nan("");
  for(const Filter& filter : {Filter::low_pass(0), Filter::low_pass(-1), Filter::high_pass(nan),
                              Filter::band_pass(1, infinity), Filter::band_stop(1, 0), Filter::low_pass(1, 0),
                              Filter::band_pass(1, nan), Filter::windowed_low_pass(1, 0),
                              Filter::windowed_low_pass(nan), Filter::approximation([](double mu) { return mu; }, 1),
                              Filter::approximation([](double) { return 1.; }, 0),
                              Filter::approximation([](double mu) { return mu; }, 1).complement()})
    GDP_CHECK(GDP::filter_spectrum(mesh, out, out, filter) == GDP::error_invalid_parameter);
  const auto not_finite = [&](double) { return nan; };
  GDP_CHECK(GDP::filter_spectrum(mesh, out, out, not_finite) == GDP::error_invalid_parameter);
  const auto identity = [](double) { return 1.; };
  const auto half = [](double) { return 0.5; };
  const Signal_map halved = signal_of(mesh, "v:halved", [](const Point&) { return 0; });
  GDP_CHECK(GDP::filter_spectrum(mesh, out, halved, half, GDP::parameters::number_of_harmonics(0)) == GDP::ok);
  GDP_CHECK_NEAR(distance(mesh, halved, [&](Vertex v) { return mesh.point(v).x() / 2; }), 0, 1e-15);
  GDP_CHECK(GDP::filter_spectrum(mesh, out, out, identity, GDP::parameters::number_of_harmonics(-1))
            == GDP::error_invalid_parameter);
  GDP_CHECK_NEAR(distance(mesh, out, [&](Vertex v) { return mesh.point(v).x(); }), 0, 0);
}

} // namespace

int main()
{
  Mesh mesh = mesh_of(sphere(8).scaled(10));
  mesh.add_vertex(Point(1, 2, 3));
  Eigen::VectorXd values;
  Eigen::MatrixXd harmonics;
  GDP_CHECK(GDP::spectrum(mesh, 9, values, harmonics) == GDP::ok);
  GDP_CHECK(values.size() == 9 && harmonics.cols() == 9 && harmonics.rows() == int(mesh.number_of_vertices()));
  for(int j = 0; j < 9; ++j)
    GDP_CHECK_NEAR(100 * values[j], j == 0 ? 0 : j < 4 ? 2 : 6, j < 4 ? 0.08 : 0.5);
  GDP_CHECK(harmonics.row(harmonics.rows() - 1).isZero(0));
  GDP_CHECK_NEAR(std::abs(harmonics(0, 0)), 1 / std::sqrt(total_area(mesh)), 1e-9);

  // a constrained vertex takes the constant's place
  auto is_constrained = mesh.add_property_map<Vertex, bool>("v:constrained", false).first;
  is_constrained[Vertex(5)] = true;
  GDP_CHECK(GDP::spectrum(mesh, 3, values, harmonics, GDP::parameters::vertex_is_constrained_map(is_constrained))
            == GDP::ok);
  GDP_CHECK(values[0] > 1e-4 && harmonics.row(5).isZero(0));

  const Eigen::VectorXd before = values;
  GDP_CHECK(GDP::spectrum(mesh, -1, values, harmonics) == GDP::error_invalid_parameter);
  GDP_CHECK(GDP::spectrum(mesh, 100000, values, harmonics) == GDP::error_invalid_parameter);
  GDP_CHECK(GDP::spectrum(Mesh(), 1, values, harmonics) == GDP::error_empty_mesh && values == before);
  test_bands();
  test_windows();
  test_no_convergence();
  test_constrained_bands();
  test_equivariance();
  test_shift();
  test_embedding_measure();
  test_region();
  test_masks();
  test_curvature_direction();
  test_spectra_of_matrices();
  test_refusals();
  test_transfer_functions();
  return GDP_TEST_RESULT();
}
