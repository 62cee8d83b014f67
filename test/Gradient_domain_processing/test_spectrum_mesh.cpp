// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// spectrum() and filter_spectrum() on meshes.

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/filter_spectrum.h>
#include <CGAL/Gradient_domain_processing/spectrum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
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

void test_refusals()
{
  Mesh mesh = mesh_of(grid(4, 4, [](double u, double v) { return Vec(u, v, 0); }));
  const Signal_map out = signal_of(mesh, "v:out", [](const Point& p) { return p.x(); });
  const double infinity = HUGE_VAL, nan = std::nan("");
  for(const Filter& filter : {Filter::low_pass(0), Filter::low_pass(-1), Filter::high_pass(nan),
                              Filter::band_pass(1, infinity), Filter::band_stop(1, 0), Filter::low_pass(1, 0)})
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
  test_constrained_bands();
  test_equivariance();
  test_refusals();
  test_transfer_functions();
  return GDP_TEST_RESULT();
}
