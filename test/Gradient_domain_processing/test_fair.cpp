// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// fair() on meshes.

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/fair.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <limits>
#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;

namespace {

// The vertices above a height, which are cut off flat.
std::vector<Vertex> cut(Mesh& mesh, double height)
{
  std::vector<Vertex> region;
  for(Vertex v : mesh.vertices())
    if(mesh.point(v).z() > height)
    {
      region.push_back(v);
      mesh.point(v) = Point(mesh.point(v).x(), mesh.point(v).y(), height);
    }
  return region;
}

void test_hole_in_a_sphere()
{
  for(double scale : {1., 1e-60, 3e40})
  {
    Mesh mesh = mesh_of(sphere(12).scaled(scale));
    const std::vector<Vertex> region = cut(mesh, 0.793 * scale);
    const Mesh flat = mesh;
    GDP_CHECK(GDP::fair(region, mesh) == GDP::ok);
    double top = 0;
    for(Vertex v : mesh.vertices())
    {
      const bool is_in = std::find(region.begin(), region.end(), v) != region.end();
      GDP_CHECK(is_in || same_bits(mesh.point(v), flat.point(v)));
      GDP_CHECK_NEAR(vec(mesh.point(v)).norm() / scale, 1, 0.01);
      top = (std::max)(top, mesh.point(v).z() / scale);
    }
    GDP_CHECK_NEAR(top, 1, 0.01);
  }
}

void test_errors()
{
  Mesh mesh = mesh_of(sphere(6));
  std::vector<Vertex> region = cut(mesh, 0.5);
  const Mesh before = mesh;
  GDP_CHECK(GDP::fair(std::vector<Vertex>(), mesh) == GDP::ok && same_points(mesh, before));
  GDP_CHECK(GDP::fair(mesh.vertices(), mesh) == GDP::error_unconstrained && same_points(mesh, before));
  GDP_CHECK(GDP::fair(region, mesh, GDP::parameters::number_of_iterations(-1)) == GDP::error_invalid_parameter
            && same_points(mesh, before));
  GDP_CHECK(GDP::fair(region, mesh, GDP::parameters::number_of_iterations(0)) == GDP::ok && same_points(mesh, before));
  GDP_CHECK(GDP::fair(region, mesh, GDP::parameters::restore_volume(true)) == GDP::error_no_volume
            && same_points(mesh, before));
  std::vector<Vertex> with_others = region;
  with_others.push_back(Vertex(1000000));
  GDP_CHECK(GDP::fair(with_others, mesh) == GDP::error_invalid_region && same_points(mesh, before));
  Mesh empty;
  GDP_CHECK(GDP::fair(std::vector<Vertex>(), empty) == GDP::error_empty_mesh);
  mesh.point(region[0]) = Point(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  GDP_CHECK(GDP::fair(region, mesh) == GDP::error_invalid_point);
}

// Some of the region is constrained; a vertex without a face, and one that was removed, do no harm.
void test_constrained()
{
  Mesh mesh = mesh_of(sphere(8));
  std::vector<Vertex> region = cut(mesh, 0.5);
  region.push_back(mesh.add_vertex(Point(7, 7, 7)));
  mesh.remove_vertex(mesh.add_vertex(Point(8, 8, 8)));
  auto is_constrained = mesh.add_property_map<Vertex, bool>("v:constrained", false).first;
  is_constrained[region[3]] = true;
  const Mesh before = mesh;
  GDP_CHECK(GDP::fair(region, mesh, GDP::parameters::vertex_is_constrained_map(is_constrained).number_of_iterations(3))
            == GDP::ok);
  GDP_CHECK(same_bits(mesh.point(region[3]), before.point(region[3]))
            && same_bits(mesh.point(region.back()), Point(7, 7, 7)));
  GDP_CHECK(mesh.point(region[5]).z() > 0.51);
  GDP_CHECK(is_finite(mesh));
}

void test_polyhedron()
{
  typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
  const Shape shape = sphere(8);
  Mesh mesh = mesh_of(shape);
  const std::vector<Vertex> region = cut(mesh, 0.5);
  Polyhedron polyhedron;
  std::vector<boost::graph_traits<Polyhedron>::vertex_descriptor> all, same_region;
  for(Vertex v : mesh.vertices())
  {
    all.push_back(add_vertex(polyhedron));
    all.back()->point() = mesh.point(v);
  }
  for(const auto& t : shape.triangles)
    CGAL::Euler::add_face(std::vector<decltype(all)::value_type>{all[t[0]], all[t[1]], all[t[2]]}, polyhedron);
  for(Vertex v : region)
    same_region.push_back(all[v]);
  GDP_CHECK(GDP::fair(region, mesh) == GDP::ok && GDP::fair(same_region, polyhedron) == GDP::ok);
  for(Vertex v : mesh.vertices())
    GDP_CHECK_NEAR((vec(mesh.point(v)) - vec(all[v]->point())).norm(), 0, 1e-12);
}

// What all verbs on positions understand: vertices that stay on their axis, or go so far only.
void test_limits()
{
  Mesh flat = mesh_of(sphere(8));
  const std::vector<Vertex> region = cut(flat, 0.5);
  Mesh along_z = flat, limited = flat;
  GDP_CHECK(GDP::fair(region, along_z, GDP::parameters::movable_axes("z")) == GDP::ok);
  GDP_CHECK(GDP::fair(region, limited, GDP::parameters::max_displacement(0.1)) == GDP::ok);
  double furthest = 0, highest = 0;
  for(Vertex v : flat.vertices())
  {
    GDP_CHECK(along_z.point(v).x() == flat.point(v).x() && along_z.point(v).y() == flat.point(v).y());
    highest = (std::max)(highest, along_z.point(v).z());
    furthest = (std::max)(furthest, (vec(limited.point(v)) - vec(flat.point(v))).norm());
  }
  GDP_CHECK_NEAR(highest, 1, 0.02);
  GDP_CHECK_NEAR(furthest, 0.1, 1e-12);
}

// A soup of the same triangles; one of squares on a sphere.
void test_soups()
{
  const Shape shape = sphere(8);
  Mesh mesh = mesh_of(shape);
  const std::vector<Vertex> region = cut(mesh, 0.5);
  std::vector<Point> points;
  std::vector<int> indices;
  for(Vertex v : mesh.vertices())
    points.push_back(mesh.point(v));
  for(Vertex v : region)
    indices.push_back(int(v));
  const std::vector<Point> before = points;
  GDP_CHECK(GDP::fair(std::vector<int>{int(points.size())}, points, shape.triangles) == GDP::error_invalid_region
            && points == before);
  GDP_CHECK(GDP::fair(region, mesh) == GDP::ok && GDP::fair(indices, points, shape.triangles) == GDP::ok);
  for(Vertex v : mesh.vertices())
    GDP_CHECK_NEAR((vec(mesh.point(v)) - vec(points[v])).norm(), 0, 1e-12);

  const int n = 12;
  std::vector<Point> corners;
  std::vector<std::vector<int> > squares;
  std::vector<int> inner;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
    {
      const Vec p = Vec(double(i) / n - 0.5, double(j) / n - 0.5, 0.8).normalized();
      const bool is_inner = i > 2 && i < n - 2 && j > 2 && j < n - 2;
      if(is_inner)
        inner.push_back(int(corners.size()));
      corners.emplace_back(p.x(), p.y(), is_inner ? 0.5 : p.z());
      if(i < n && j < n)
        squares.push_back({i * (n + 1) + j, (i + 1) * (n + 1) + j, (i + 1) * (n + 1) + j + 1, i * (n + 1) + j + 1});
    }
  GDP_CHECK(GDP::fair(inner, corners, squares) == GDP::ok);
  for(const Point& p : corners)
    GDP_CHECK_NEAR(vec(p).norm(), 1, 0.06); // coarse squares stay a little above
}

} // namespace

int main()
{
  test_hole_in_a_sphere();
  test_errors();
  test_constrained();
  test_polyhedron();
  test_limits();
  test_soups();
  return GDP_TEST_RESULT();
}
