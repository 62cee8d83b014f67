// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Soups of points and polygons: the result is that of the mesh they make, in any order, with any number of polygons at
// an edge, and with the seams welded where that is asked for.

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/denoise.h>
#include <CGAL/Gradient_domain_processing/enhance_details.h>
#include <CGAL/Gradient_domain_processing/fit_to_normals.h>
#include <CGAL/Gradient_domain_processing/process_signal.h>
#include <CGAL/Gradient_domain_processing/sharpen.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;

namespace {

typedef std::vector<Point> Points;
typedef std::vector<std::array<int, 3> > Triangles;

Points points_of(const Shape& shape)
{
  Points points;
  for(const Vec& p : shape.points)
    points.emplace_back(p.x(), p.y(), p.z());
  return points;
}

double distance(const Points& a, const Points& b)
{
  double most = 0;
  for(std::size_t v = 0; v < a.size(); ++v)
    most = (std::max)(most, (vec(a[v]) - vec(b[v])).norm());
  return most;
}

Points points_of(const Mesh& mesh)
{
  return Points(mesh.points().begin(), mesh.points().end());
}

Shape wavy_patch()
{
  return jittered_square(14)
    .mapped([](const Vec& p) { return Vec(p.x(), p.y(), 0.1 * std::sin(7 * p.x()) * p.y()); })
    .noisy(0.004);
}

// Every verb, by number, on whatever it is given: a mesh or a soup, with a region before it or not.
constexpr int number_of_verbs = 6;
template <class... Surface>
GDP::Error_code run(int verb, Surface&... surface)
{
  const auto np = GDP::parameters::gradient_weight(2e-3);
  switch(verb)
  {
    case 0: return GDP::smooth(surface..., np);
    case 1: return GDP::sharpen(surface..., np.value_weight(2.).border_condition(GDP::Border_condition::ALONG_BORDER));
    case 2: return GDP::smooth(surface..., np.curvature_weight(0.05).number_of_iterations(2));
    case 3: return GDP::enhance_details(surface..., np.border_condition(GDP::Border_condition::FIXED));
    case 4: return GDP::denoise(surface..., GDP::parameters::noise_level(0.2).number_of_iterations(2));
    default: return GDP::smooth(surface..., np.non_shrinking_order(2));
  }
}

void test_soup_is_mesh()
{
  for(const Shape& shape : {sphere(7).noisy(0.02), wavy_patch()})
    for(int verb = 0; verb < number_of_verbs; ++verb)
    {
      const double tolerance = verb == 4 ? 1e-6 : 1e-9; // denoising is in single precision inside
      Mesh mesh = mesh_of(shape);
      Points points = points_of(shape);
      GDP_CHECK(run(verb, mesh) == GDP::ok && run(verb, points, shape.triangles) == GDP::ok);
      GDP_CHECK_NEAR(distance(points, points_of(mesh)), 0, tolerance);
      GDP_CHECK(distance(points, points_of(shape)) > 1e-4);

      Mesh in_region = mesh_of(shape);
      std::vector<Face> region(in_region.faces().begin(),
                               std::next(in_region.faces().begin(), in_region.number_of_faces() / 3));
      std::vector<std::size_t> indices(region.size());
      std::iota(indices.begin(), indices.end(), std::size_t(0));
      Points of_region = points_of(shape);
      GDP_CHECK(run(verb, region, in_region) == GDP::ok && run(verb, indices, of_region, shape.triangles) == GDP::ok);
      GDP_CHECK_NEAR(distance(of_region, points_of(in_region)), 0, tolerance);
    }
}

// Triangles that have lost their neighbors are a mesh again once they are welded, and near enough ones with a
// tolerance.
void test_welding()
{
  for(const Shape& shape : {sphere(7).noisy(0.02), wavy_patch()})
  {
    Points apart, near;
    Triangles triangles;
    Random random(3);
    for(const auto& t : shape.triangles)
    {
      for(int v : t)
      {
        const Vec& p = shape.points[v];
        apart.emplace_back(p.x(), p.y(), p.z());
        near.emplace_back(p.x() + 1e-7 * random(), p.y() + 1e-7 * random(), p.z() + 1e-7 * random());
      }
      const int n = int(apart.size());
      triangles.push_back({{n - 3, n - 2, n - 1}});
    }
    const auto np = GDP::parameters::gradient_weight(2e-3);
    Points whole = points_of(shape), welded = apart, welded_near = near, loose = apart;
    GDP_CHECK(GDP::smooth(whole, shape.triangles, np) == GDP::ok);
    GDP_CHECK(GDP::smooth(welded, triangles, np.weld_tolerance(0.)) == GDP::ok);
    GDP_CHECK(GDP::smooth(welded_near, triangles, np.weld_tolerance(1e-6)) == GDP::ok);
    GDP_CHECK(GDP::smooth(loose, triangles, np) == GDP::ok);
    double most = 0, most_near = 0, most_loose = 0;
    for(std::size_t f = 0; f < triangles.size(); ++f)
      for(int i = 0; i < 3; ++i)
      {
        const Vec expected = vec(whole[shape.triangles[f][i]]);
        most = (std::max)(most, (vec(welded[triangles[f][i]]) - expected).norm());
        most_near = (std::max)(most_near, (vec(welded_near[triangles[f][i]]) - expected).norm());
        most_loose = (std::max)(most_loose, (vec(loose[triangles[f][i]]) - expected).norm());
        // every copy gets the same change, so near ones stay as near as they were
        const std::size_t first = std::size_t(triangles[f][i]);
        GDP_CHECK((vec(welded_near[first]) - vec(near[first]) - (expected - shape.points[shape.triangles[f][i]])).norm()
                  < 1e-5);
      }
    GDP_CHECK(most < 1e-12);
    GDP_CHECK(most_near < 1e-5);
    GDP_CHECK(most_loose > 0.01); // without welding every triangle shrinks for itself
    const auto solver = GDP::make_gradient_domain_solver(apart, triangles, np.weld_tolerance(0.));
    GDP_CHECK(solver.number_of_welded_vertices() == apart.size() - shape.points.size());
  }
}

// Points that no face uses may be anywhere: they say nothing about the extent, to which the tolerance of welding and
// the powers of two of the arrays refer. A tolerance below the digits of the coordinates welds what is in the same
// place.
void test_points_without_face()
{
  const Shape shape = wavy_patch();
  Points apart;
  Triangles triangles;
  for(const auto& t : shape.triangles)
  {
    const int n = int(apart.size());
    for(int v : t)
      apart.emplace_back(shape.points[v].x() + 1e-8 * n, shape.points[v].y(), shape.points[v].z());
    triangles.push_back({{n, n + 1, n + 2}});
  }
  const auto np = GDP::parameters::gradient_weight(2e-3);
  Points welded = apart, whole = points_of(shape);
  GDP_CHECK(GDP::smooth(welded, triangles, np.weld_tolerance(1e-4)) == GDP::ok);
  GDP_CHECK(GDP::smooth(whole, shape.triangles, np) == GDP::ok);
  for(double tolerance : {1e-20, 1e-300})
  {
    Points same = points_of(shape);
    GDP_CHECK(GDP::smooth(same, shape.triangles, np.weld_tolerance(tolerance)) == GDP::ok);
    GDP_CHECK(distance(same, whole) == 0);
  }
  const double nan_value = std::numeric_limits<double>::quiet_NaN();
  for(const Point& other : {Point(1e149, 0, 0), Point(-1e100, 3e120, 1), Point(1e9, 0, 0), Point(nan_value, 0, 0)})
  {
    Points with_others = apart, whole_with_others = points_of(shape);
    with_others.push_back(other);
    whole_with_others.push_back(other);
    GDP_CHECK(GDP::smooth(with_others, triangles, np.weld_tolerance(1e-4)) == GDP::ok);
    GDP_CHECK(GDP::smooth(whole_with_others, shape.triangles, np) == GDP::ok);
    GDP_CHECK(same_bits(with_others.back(), other) && same_bits(whole_with_others.back(), other));
    GDP_CHECK(distance(welded, with_others) < 1e-12 && distance(whole, whole_with_others) < 1e-12);

    Mesh mesh = mesh_of(shape);
    mesh.add_vertex(other);
    GDP_CHECK(GDP::smooth(mesh, np) == GDP::ok);
    GDP_CHECK(distance(whole, points_of(mesh)) < 1e-12);
  }
}

// Triangles that are turned over make no difference; there is no volume to restore then.
void test_turned_triangles()
{
  const Shape shape = sphere(6).noisy(0.02);
  Triangles turned = shape.triangles;
  Random random(5);
  for(auto& t : turned)
    if(random() > 0)
      std::swap(t[1], t[2]);
  const auto np = GDP::parameters::gradient_weight(5e-3).number_of_iterations(2);
  Points points = points_of(shape), same = points;
  GDP_CHECK(GDP::smooth(points, shape.triangles, np) == GDP::ok && GDP::smooth(same, turned, np) == GDP::ok);
  GDP_CHECK(distance(points, same) < 1e-12);
  GDP_CHECK(GDP::smooth(same, turned, np.restore_volume(true)) == GDP::error_no_volume);
  GDP_CHECK(distance(points, same) < 1e-12);
}

// A signal that jumps at a seam goes on jumping by as much, and is filtered on both sides as one.
void test_signal_at_seam()
{
  const int n = 12;
  const Shape left = square(n), right = left.moved(Vec(1, 0, 0)), both = left + right;
  const Shape whole = grid(2 * n, n, [](double u, double v) { return Vec(2 * u, v, 0); });
  const auto f = [](const Vec& p) { return std::sin(5 * p.x()) + p.y() * p.y(); };
  std::vector<double> in, in_whole;
  for(std::size_t v = 0; v < both.points.size(); ++v)
    in.push_back(f(both.points[v]) + (v < left.points.size() ? 0 : 10));
  for(const Vec& p : whole.points)
    in_whole.push_back(f(p));
  std::vector<double> out(in.size()), out_whole(in_whole.size());
  const auto np = GDP::parameters::gradient_weight(3e-3);
  GDP_CHECK(GDP::process_signal(points_of(both), both.triangles, CGAL::make_property_map(in),
                                CGAL::make_property_map(out), np.weld_tolerance(0.))
            == GDP::ok);
  GDP_CHECK(GDP::process_signal(points_of(whole), whole.triangles, CGAL::make_property_map(in_whole),
                                CGAL::make_property_map(out_whole), np) == GDP::ok);
  double most = 0, moved = 0;
  for(std::size_t v = 0; v < both.points.size(); ++v)
    for(std::size_t w = 0; w < whole.points.size(); ++w)
      if((both.points[v] - whole.points[w]).norm() < 1e-9)
      {
        most = (std::max)(most, std::abs(out[v] - (v < left.points.size() ? 0 : 10) - out_whole[w]));
        moved = (std::max)(moved, std::abs(out[v] - in[v]));
      }
  GDP_CHECK(most < 1e-3); // the diagonals of the two squares and of the whole differ
  GDP_CHECK(moved > 0.05);
}

// Three sheets at an edge, two fans at a vertex: the sheets stay together.
void test_non_manifold()
{
  Shape sheets;
  const int n = 8;
  for(int sheet = 0; sheet < 3; ++sheet)
  {
    const double angle = 2 * pi * sheet / 3;
    sheets = sheets + grid(n, n, [&](double u, double v) { return Vec(u * std::cos(angle), u * std::sin(angle), v); });
  }
  std::vector<int> number(sheets.points.size());
  Shape joined;
  for(std::size_t v = 0; v < number.size(); ++v)
  {
    std::size_t same = 0;
    while(same < joined.points.size() && (joined.points[same] - sheets.points[v]).norm() > 1e-12)
      ++same;
    if(same == joined.points.size())
      joined.points.push_back(sheets.points[v]);
    number[v] = int(same);
  }
  for(const auto& t : sheets.triangles)
    joined.triangles.push_back({{number[t[0]], number[t[1]], number[t[2]]}});
  const Shape noisy = joined.noisy(0.01);
  for(int verb = 0; verb < number_of_verbs; ++verb)
  {
    Points points = points_of(noisy);
    GDP_CHECK(run(verb, points, noisy.triangles) == GDP::ok);
    GDP_CHECK(distance(points, points_of(noisy)) > 1e-4);
    for(const Point& p : points)
      GDP_CHECK(vec(p).allFinite());
  }
  // the edge is no border: a fixed border does not hold its inner vertices
  Points points = points_of(noisy);
  GDP_CHECK(GDP::smooth(points, noisy.triangles,
                        GDP::parameters::gradient_weight(1e-2).border_condition(GDP::Border_condition::FIXED))
            == GDP::ok);
  for(std::size_t v = 0; v < points.size(); ++v)
  {
    const Vec& p = joined.points[v];
    const double radius = std::hypot(p.x(), p.y());
    const bool is_border = p.z() < 1e-9 || p.z() > 1 - 1e-9 || radius > 1 - 1e-9;
    GDP_CHECK(is_border == same_bits(points[v], points_of(noisy)[v]));
  }

  Shape bow = square(4) + square(4).mapped([](const Vec& p) { return Vec(-p.x(), -p.y(), 0.5 * p.x()); });
  for(auto& t : bow.triangles) // two fans at the origin
    for(int& v : t)
      if(bow.points[v].norm() == 0)
        v = 0;
  Points at_bow = points_of(bow.noisy(0.02));
  GDP_CHECK(GDP::smooth(at_bow, bow.triangles) == GDP::ok);
}

// A linear signal on polygons of any kind is as it was under any weight where its border is held; quads are squares of
// their diagonals.
void test_polygons()
{
  Random random(11);
  const int n = 9;
  Points points;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
    {
      const bool inside = i > 0 && j > 0 && i < n && j < n;
      points.emplace_back(i + (inside ? 0.3 * random() : 0.), j + (inside ? 0.3 * random() : 0.), 0);
    }
  const auto at = [&](int i, int j) { return i * (n + 1) + j; };
  std::vector<std::vector<int> > polygons;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      if(i % 3 == 0 && j + 1 < n && j % 2 == 0) // hexagons, triangles, quads
      {
        polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i + 1, j + 2), at(i, j + 2), at(i, j + 1)});
        ++j;
      }
      else if(i % 3 == 1)
      {
        polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        polygons.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
      else
        polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  std::vector<double> in, out(points.size());
  for(const Point& p : points)
    in.push_back(3 * p.x() - 2 * p.y() + 1);
  for(double alpha : {0., 1.})
  {
    GDP_CHECK(GDP::process_signal(
                points, polygons, CGAL::make_property_map(in), CGAL::make_property_map(out),
                GDP::parameters::gradient_weight(1.).value_weight(alpha).gradient_scale(alpha).border_condition(
                  GDP::Border_condition::FIXED))
              == GDP::ok);
    for(std::size_t v = 0; v < in.size(); ++v)
      GDP_CHECK_NEAR(out[v], in[v], 1e-11);
  }
  // harmonic from wrong values inside
  std::vector<double> wrong = in;
  for(int i = 1; i < n; ++i)
    for(int j = 1; j < n; ++j)
      wrong[at(i, j)] += random();
  GDP_CHECK(GDP::process_signal(points, polygons, CGAL::make_property_map(wrong), CGAL::make_property_map(out),
    GDP::parameters::value_weight(0.).border_condition(GDP::Border_condition::FIXED)) == GDP::ok);
  for(std::size_t v = 0; v < in.size(); ++v)
    GDP_CHECK_NEAR(out[v], in[v], 1e-10);

  // polygons of a halfedge mesh, and the same as a soup; the area is what weights are relative to
  Mesh quads;
  for(const Point& p : points)
    quads.add_vertex(Point(p.x(), p.y(), 0.3 * std::sin(p.x())));
  for(const auto& polygon : polygons)
  {
    std::vector<Vertex> corners;
    for(int v : polygon)
      corners.push_back(Vertex(v));
    GDP_CHECK(quads.add_face(corners) != Mesh::null_face());
  }
  Points of_quads = points_of(quads);
  const Points before = of_quads;
  GDP_CHECK(GDP::smooth(quads) == GDP::ok && GDP::smooth(of_quads, polygons) == GDP::ok);
  GDP_CHECK(distance(of_quads, points_of(quads)) < 1e-10);
  GDP_CHECK(distance(of_quads, before) > 1e-4);
}

void test_errors()
{
  const Shape shape = square(3);
  const Points before = points_of(shape);
  Points points = before;
  Triangles out_of_range = shape.triangles;
  out_of_range[4][1] = int(points.size());
  GDP_CHECK(GDP::smooth(points, out_of_range) == GDP::error_invalid_index);
  out_of_range[4][1] = -1;
  GDP_CHECK(GDP::smooth(points, out_of_range) == GDP::error_invalid_index);
  GDP_CHECK(GDP::smooth(points, Triangles()) == GDP::error_empty_mesh);
  GDP_CHECK(GDP::smooth(points, std::vector<std::vector<int> >{{0, 1}}) == GDP::error_non_triangular_mesh);
  GDP_CHECK(GDP::smooth(std::vector<std::size_t>{0, 999}, points, shape.triangles) == GDP::error_invalid_region);
  GDP_CHECK(points == before);
  GDP_CHECK(GDP::smooth(std::vector<std::size_t>(), points, shape.triangles) == GDP::ok && points == before);

  // points that no polygon uses may be anything
  const double nan_value = std::numeric_limits<double>::quiet_NaN();
  points.emplace_back(nan_value, 1, 2);
  GDP_CHECK(GDP::smooth(points, shape.triangles) == GDP::ok);
  GDP_CHECK(std::isnan(points.back().x()) && points.back().y() == 1);
  points[2] = Point(0, nan_value, 0);
  GDP_CHECK(GDP::smooth(points, shape.triangles) == GDP::error_invalid_point);

  // points of one's own
  struct Own_point
  {
    double coordinates[3];
    Own_point(double x, double y, double z) : coordinates{x, y, z} {}
    double x() const { return coordinates[0]; }
    double y() const { return coordinates[1]; }
    double z() const { return coordinates[2]; }
  };
  const Shape ball = sphere(4);
  std::vector<Own_point> own;
  for(const Vec& p : ball.points)
    own.emplace_back(p.x(), p.y(), p.z());
  Points same = points_of(ball);
  GDP_CHECK(GDP::smooth(own, ball.triangles) == GDP::ok && GDP::smooth(same, ball.triangles) == GDP::ok);
  for(std::size_t v = 0; v < own.size(); ++v)
    GDP_CHECK(own[v].x() == same[v].x() && own[v].y() == same[v].y() && own[v].z() == same[v].z());
}

} // namespace

int main()
{
  test_soup_is_mesh();
  test_welding();
  test_points_without_face();
  test_turned_triangles();
  test_signal_at_seam();
  test_non_manifold();
  test_polygons();
  test_errors();
  return GDP_TEST_RESULT();
}
