// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The enclosed volume restored after smoothing, component by component.

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/denoise.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/offset_to_volumes.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/polygon_fans.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <array>
#include <utility>
#include <vector>

namespace GDP = CGAL::Gradient_domain_processing;
using namespace gdp_test;

GDP::Error_code run(Mesh& mesh, bool restore, double weight, double scale = 0, int constrained = -1, int iterations = 1,
                    GDP::Border_condition condition = GDP::Border_condition::FREE)
{
  auto map = mesh.add_property_map<Vertex, bool>("v:constrained", false).first;
  if(constrained >= 0)
    map[Vertex(constrained)] = true;
  const GDP::Error_code code = GDP::smooth(mesh, GDP::parameters::restore_volume(restore)
                                                   .gradient_weight(weight)
                                                   .gradient_scale(scale)
                                                   .number_of_iterations(iterations)
                                                   .vertex_is_constrained_map(map)
                                                   .border_condition(condition));
  mesh.remove_property_map(map);
  return code;
}

// Volumes and surface centroids of the components, whose vertices end at `ends`.
struct Component
{
  double volume = 0, area = 0;
  Vec centroid = Vec(0, 0, 0);
};

std::vector<Component> components(const Mesh& mesh, const std::vector<std::size_t>& ends)
{
  std::vector<Component> result(ends.size());
  std::vector<Vec> origin(ends.size());
  for(std::size_t i = 0; i < ends.size(); ++i)
    origin[i] = vec(mesh.point(Vertex(i == 0 ? 0 : int(ends[i - 1]))));
  for(Face f : mesh.faces())
  {
    const auto c = corners(mesh, f);
    const std::size_t i = std::upper_bound(ends.begin(), ends.end(), std::size_t(c[0])) - ends.begin();
    const Vec p = vec(mesh.point(c[0])) - origin[i], q = vec(mesh.point(c[1])) - origin[i],
              r = vec(mesh.point(c[2])) - origin[i];
    const double area = area_vector(mesh, f).norm();
    result[i].volume += p.dot(q.cross(r)) / 6;
    result[i].area += area;
    result[i].centroid += area * (p + q + r) / 3;
  }
  for(std::size_t i = 0; i < ends.size(); ++i)
    result[i].centroid = origin[i] + result[i].centroid / result[i].area;
  return result;
}

void test_closed_meshes()
{
  Shape inverted = sphere(4).scaled(0.5).moved(Vec(0, 4, 0)); // inside out: its volume is negative, and kept
  for(auto& t : inverted.triangles)
    std::swap(t[1], t[2]);
  const Shape torus = grid(24, 12, [](double u, double v) {
    const double r = 1 + 0.4 * std::cos(2 * pi * v);
    return Vec(r * std::cos(2 * pi * u), r * std::sin(2 * pi * u), 5 + 0.4 * std::sin(2 * pi * v));
  }, true, true);
  const std::vector<Shape> shapes = {sphere(8).noisy(0.03), ellipsoid(6, Vec(1, 0.5, 0.3)).moved(Vec(4, 0, 0)),
                                     inverted, torus, cubes({{{0, 0, 0}}, {{1, 0, 0}}}, 4).moved(Vec(-5, 0, 0))};
  Shape all;
  std::vector<std::size_t> ends;
  for(const Shape& shape : shapes)
  {
    all = all + shape;
    ends.push_back(all.points.size());
  }
  for(double size : {1e-3, 1., 1e6})
    for(double offset : {0., 100.})
      for(int iterations : {1, 4})
        for(double scale : {0., 2.})
        {
          const double weight = scale == 0 ? 1e-4 : 1e-5;
          const Mesh before = mesh_of(all.scaled(size).moved(Vec(offset * size, 0, -offset * size)));
          Mesh restored = before, plain = before;
          GDP_CHECK(run(restored, true, weight, scale, -1, iterations) == GDP::OK);
          GDP_CHECK(run(plain, false, weight, scale, -1, iterations) == GDP::OK);
          const auto a = components(before, ends), b = components(restored, ends), c = components(plain, ends);
          for(std::size_t i = 0; i < a.size(); ++i)
          {
            // rounding of the coordinates where the mesh is far from the origin
            const double tolerance = offset == 0 ? 1e-12 : 1e-11;
            GDP_CHECK_NEAR(b[i].volume / a[i].volume, 1, tolerance);
            GDP_CHECK(std::abs(c[i].volume / a[i].volume - 1) > 1e-4);
            if(iterations > 1) // restored after every pass, so the passes see other meshes
              continue;
            GDP_CHECK_NEAR((b[i].centroid - c[i].centroid).norm() / size, 0, 1e-11); // about the centroid
            const double factor = std::cbrt(a[i].volume / c[i].volume); // nothing but a scaling
            GDP_CHECK_NEAR(b[i].area / c[i].area / (factor * factor), 1, 1e-11);
          }
        }
}

void test_meshes_without_volume()
{
  const Shape ball = sphere(4), patch = square(4).moved(Vec(4, 0, 0));
  Shape opened = ball;
  opened.triangles.pop_back();
  for(const Shape& shape : {opened, patch, ball + patch})
  {
    const Mesh before = mesh_of(shape);
    for(GDP::Border_condition condition :
        {GDP::Border_condition::FREE, GDP::Border_condition::FIXED, GDP::Border_condition::ALONG_BORDER})
    {
      Mesh mesh = before;
      GDP_CHECK(run(mesh, true, 1e-3, 0, -1, 1, condition) == GDP::ERROR_NO_VOLUME);
      GDP_CHECK(same_points(mesh, before));
      GDP_CHECK(run(mesh, false, 1e-3, 0, -1, 1, condition) == GDP::OK);
    }
  }
  const Mesh before = mesh_of(ball);
  Mesh mesh = before;
  GDP_CHECK(run(mesh, true, 1e-3, 0, 3) == GDP::ERROR_NO_VOLUME);
  GDP_CHECK(same_points(mesh, before));
  GDP_CHECK(run(mesh, true, 1e-3) == GDP::OK);

  // a closed mesh is no less closed with a vertex that has no face
  Mesh with_vertex = before;
  with_vertex.add_vertex(Point(9, 9, 9));
  GDP_CHECK(run(with_vertex, true, 1e-3) == GDP::OK);
  for(Vertex v : before.vertices())
    GDP_CHECK_NEAR((vec(with_vertex.point(v)) - vec(mesh.point(v))).norm(), 0, 1e-12);
  GDP_CHECK(with_vertex.point(Vertex(int(before.number_of_vertices()))) == Point(9, 9, 9));

  // a ring that is pressed flat: closed, without volume, nothing to scale
  const Shape pressed = grid(24, 12, [](double u, double v) {
    const double r = 1 + 0.4 * std::cos(2 * pi * v);
    return Vec(r * std::cos(2 * pi * u), r * std::sin(2 * pi * u), 0);
  }, true, true);
  // and tilted: all its volume is rounding
  for(const Vec& normal : {Vec(0, 0, 1), Vec(0.36, 0.48, 0.8), Vec(0.3, -0.5, 0.7).normalized()})
  {
    const auto turn = Eigen::Quaterniond::FromTwoVectors(Vec(0, 0, 1), normal);
    Mesh flat = mesh_of(pressed.mapped([&](const Vec& p) { return Vec(turn * p); })), plain = flat;
    GDP_CHECK(run(flat, true, 1e-3) == GDP::OK);
    GDP_CHECK(run(plain, false, 1e-3) == GDP::OK);
    for(Vertex v : flat.vertices())
      GDP_CHECK_NEAR((vec(flat.point(v)) - vec(plain.point(v))).norm(), 0, 1e-12);
  }
}

// A cube of six squares, all planes of which moved inward alike, gets its planes back, and so do the virtual vertices
// in their middles; one that would have to move too far stays as it is.
void test_offsets()
{
  GDP::internal::Indexed_triangles mesh;
  GDP::internal::Lists squares;
  squares.offsets = {0};
  for(int cube = 0; cube < 2; ++cube)
  {
    for(int i = 0; i < 8; ++i)
      mesh.points.push_back(Vec(i & 1, i >> 1 & 1, i >> 2) + Vec(3 * cube, 0, 0));
    for(const auto& square : {std::array<int, 4>{{0, 2, 3, 1}}, {{4, 5, 7, 6}}, {{0, 1, 5, 4}}, {{2, 6, 7, 3}},
                              {{0, 4, 6, 2}}, {{1, 3, 7, 5}}})
    {
      for(int corner : square)
        squares.items.push_back(8 * cube + corner);
      squares.offsets.push_back(int(squares.items.size()));
    }
  }
  GDP::internal::fan_polygons(squares, mesh);
  mesh.index_corners();
  GDP_CHECK(mesh.points.size() == 28 && mesh.triangles.size() == 48);
  const std::vector<GDP::internal::Vec3> before = mesh.points;
  std::vector<GDP::internal::Vec3> after;
  for(const Vec& p : before)
  {
    const Vec center(p.x() < 2 ? 0.5 : 3.5, 0.5, 0.5);
    after.push_back(center + (p.x() < 2 ? 0.9 : 0.3) * (p - center));
  }
  const auto moved = after;
  GDP_CHECK(GDP::internal::offset_to_volumes(mesh, before, false, after) == 1);
  for(std::size_t v = 0; v < before.size(); ++v)
    GDP_CHECK_NEAR((after[v] - (before[v].x() < 2 ? before[v] : moved[v])).norm(), 0, 1e-12);
}

void test_polygon_area()
{
  const auto area = [](const std::vector<Vec>& polygon) { return GDP::internal::polygon_area(polygon); };
  GDP_CHECK_NEAR(area({Vec(0, 0, 0), Vec(2, 0, 0), Vec(0, 3, 0)}), 3, 1e-12);
  GDP_CHECK_NEAR(area({Vec(0, 0, 0), Vec(2, 0, 1), Vec(2, 3, 1), Vec(0, 3, 0)}), 3 * std::sqrt(5.), 1e-12);
  GDP_CHECK_NEAR(area({Vec(0, 0, 0), Vec(2, 0, 0), Vec(2, 1, 0), Vec(1, 2, 0), Vec(0, 1, 0)}), 3, 1e-12);
}

// A closed soup encloses nothing that one could speak of where a triangle is the wrong way around, or a wall has rooms
// on both sides.
void test_soups_without_orientation()
{
  const Shape ball = sphere(4);
  Shape turned = ball, walled = ball;
  std::swap(turned.triangles[5][1], turned.triangles[5][2]);
  const int center = int(walled.points.size());
  walled.points.push_back(Vec(0, 0, 0)); // a fan from a closed ring of edges to the center
  int west = 0;
  for(int v = 0; v < center; ++v)
    if(ball.points[v].x() < ball.points[west].x())
      west = v;
  for(const auto& t : ball.triangles)
    for(int i = 0; i < 3; ++i)
      if(t[(i + 2) % 3] == west)
        walled.triangles.push_back({{t[i], t[(i + 1) % 3], center}});
  for(const Shape& shape : {ball, turned, walled})
  {
    std::vector<Point> points;
    for(const Vec& p : shape.points)
      points.push_back(Point(p.x(), p.y(), p.z()));
    const std::vector<Point> before = points;
    const GDP::Error_code code =
      GDP::smooth(points, shape.triangles, GDP::parameters::gradient_weight(1e-3).restore_volume(true));
    GDP_CHECK(code == (shape.triangles == ball.triangles ? GDP::ok : GDP::error_no_volume));
    GDP_CHECK((points == before) == (code != GDP::ok));
    points = before; // by default only where there is a volume
    GDP_CHECK(GDP::denoise(points, shape.triangles, GDP::parameters::number_of_iterations(2).noise_level(0.3))
              == GDP::ok);
    GDP_CHECK(points != before);
  }
}

// A face that is turned over is seen however small it is.
void test_small_turned_face()
{
  Shape shape = sphere(4);
  const auto [a, b, c] = shape.triangles.front();
  const int first = int(shape.points.size());
  const Vec center = (shape.points[a] + shape.points[b] + shape.points[c]) / 3;
  for(int corner : {a, b, c})
    shape.points.push_back(center + 1e-4 * (shape.points[corner] - center));
  const int p = first, q = first + 1, r = first + 2;
  shape.triangles.front() = {{p, q, r}};
  for(const auto& t : {std::array<int, 3>{{a, b, q}}, {{a, q, p}}, {{b, c, r}}, {{b, r, q}}, {{c, a, p}}, {{c, p, r}}})
    shape.triangles.push_back({{t[0], t[1], t[2]}});
  for(bool is_turned : {false, true})
  {
    if(is_turned)
      std::swap(shape.triangles.front()[0], shape.triangles.front()[1]);
    std::vector<Point> points;
    for(const Vec& x : shape.points)
      points.push_back(Point(x.x(), x.y(), x.z()));
    const auto np = GDP::parameters::gradient_weight(1e-3).restore_volume(true);
    GDP_CHECK(GDP::smooth(points, shape.triangles, np) == (is_turned ? GDP::error_no_volume : GDP::ok));
  }
}

// Passes that would shrink a sphere to a point, one after the other.
void test_many_passes()
{
  const Mesh before = mesh_of(sphere(8));
  const auto volume = [](const Mesh& mesh) { return components(mesh, {mesh.number_of_vertices()})[0].volume; };
  Mesh restored = before;
  GDP_CHECK(run(restored, true, 1e-3, 0, -1, 50) == GDP::OK);
  GDP_CHECK_NEAR(volume(restored) / volume(before), 1, 1e-10);
  for(Vertex v : restored.vertices())
    GDP_CHECK_NEAR(vec(restored.point(v)).norm(), 1, 0.02);
  Mesh plain = before;
  GDP_CHECK(run(plain, false, 1e-3, 0, -1, 50) == GDP::OK);
  GDP_CHECK(volume(plain) < 1e-2 * volume(before)); // while without it
}

int main()
{
  test_many_passes();
  test_closed_meshes();
  test_meshes_without_volume();
  test_soups_without_orientation();
  test_small_turned_face();
  test_offsets();
  test_polygon_area();
  return GDP_TEST_RESULT();
}
