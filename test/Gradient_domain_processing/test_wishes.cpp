// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Wishes of people with files: smoothing that does not shrink, no vertex further than a limit, along some axes only,
// missing values.

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/fit_to_normals.h>
#include <CGAL/Gradient_domain_processing/process_signal.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;

namespace {

double mean_radius(const Mesh& mesh)
{
  double sum = 0;
  for(Vertex v : mesh.vertices())
    sum += vec(mesh.point(v)).norm();
  return sum / double(mesh.number_of_vertices());
}

// A sphere is an eigenfunction: its radius becomes 1 - (t mu / (1 + t mu))^k with mu = 2.
void test_not_shrinking()
{
  const Mesh ball = mesh_of(sphere(16, 0));
  for(double t : {0.01, 0.1})
    for(int order : {1, 2, 3, 6})
    {
      Mesh mesh = ball;
      GDP_CHECK(
        GDP::smooth(mesh, GDP::parameters::gradient_weight(t).area_normalization(false).non_shrinking_order(order))
        == GDP::ok);
      GDP_CHECK_NEAR(mean_radius(mesh), 1 - std::pow(2 * t / (1 + 2 * t), order), 1e-3);
    }
  // two are smoothing followed by sharpening with lambda 2
  const Mesh rough = mesh_of(sphere(8).noisy(0.03));
  Mesh twice = rough, in_turn = rough;
  GDP_CHECK(GDP::smooth(twice, GDP::parameters::gradient_weight(1e-3).non_shrinking_order(2)) == GDP::ok);
  auto solver = GDP::make_gradient_domain_solver(rough, GDP::parameters::gradient_weight(1e-3));
  const auto map = in_turn.points();
  GDP_CHECK(solver.filter(map, map) == GDP::ok && solver.set_gradient_scale(2) == GDP::ok
            && solver.filter(map, map) == GDP::ok);
  GDP_CHECK(distance(twice, in_turn) < 1e-12);
  GDP_CHECK(GDP::smooth(twice, GDP::parameters::non_shrinking_order(0)) == GDP::error_invalid_parameter);
}

struct Notices : GDP::Default_visitor
{
  std::vector<std::string> sentences;
  void notice(const std::string& sentence) { sentences.push_back(sentence); }
};

void test_limits()
{
  const Mesh before = mesh_of(sphere(8).noisy(0.05).scaled(1e3));
  Mesh mesh = before, plain = before;
  Notices notices;
  GDP_CHECK(GDP::smooth(plain, GDP::parameters::gradient_weight(1e-3)) == GDP::ok);
  GDP_CHECK(GDP::smooth(mesh, GDP::parameters::gradient_weight(1e-3).max_displacement(10.).visitor(std::ref(notices)))
            == GDP::ok);
  GDP_CHECK(notices.sentences.size() == 1);
  int limited = 0;
  for(Vertex v : mesh.vertices())
  {
    const Vec wanted = vec(plain.point(v)) - vec(before.point(v)), move = vec(mesh.point(v)) - vec(before.point(v));
    const double length = wanted.norm();
    limited += length > 10;
    GDP_CHECK_NEAR((move - (length > 10 ? Vec(10 / length * wanted) : wanted)).norm(), 0, 1e-9);
  }
  GDP_CHECK(limited > 20 && limited < int(mesh.number_of_vertices()) - 20);
  GDP_CHECK(GDP::smooth(mesh, GDP::parameters::max_displacement(-1.)) == GDP::error_invalid_parameter);
  GDP_CHECK(GDP::smooth(mesh, GDP::parameters::max_displacement(std::nan(""))) == GDP::error_invalid_parameter);

  Mesh terrain = before;
  GDP_CHECK(GDP::smooth(terrain, GDP::parameters::gradient_weight(1e-3).movable_axes("z")) == GDP::ok);
  for(Vertex v : terrain.vertices())
  {
    GDP_CHECK(terrain.point(v).x() == before.point(v).x() && terrain.point(v).y() == before.point(v).y());
    GDP_CHECK_NEAR(terrain.point(v).z(), plain.point(v).z(), 1e-9);
  }
  GDP_CHECK(GDP::smooth(terrain, GDP::parameters::movable_axes("zq")) == GDP::error_invalid_parameter);
  GDP_CHECK(GDP::smooth(terrain, GDP::parameters::movable_axes("z").restore_volume(true)) == GDP::error_no_volume);
}

// Missing values of a linear signal on a square come back, and the others stay as they were without them.
void test_missing_values()
{
  const Mesh mesh = mesh_of(jittered_square(12));
  std::vector<double> in, out(mesh.number_of_vertices());
  for(Vertex v : mesh.vertices())
    in.push_back(2 * mesh.point(v).x() - mesh.point(v).y());
  std::vector<double> with_holes = in;
  int holes = 0;
  for(Vertex v : mesh.vertices())
    if((vec(mesh.point(v)) - Vec(0.5, 0.4, 0)).norm() < 0.2)
    {
      with_holes[v] = std::numeric_limits<double>::quiet_NaN();
      ++holes;
    }
  GDP_CHECK(holes > 8);
  const auto map = CGAL::make_property_map(out);
  const auto np = GDP::parameters::gradient_weight(1e-6).gradient_scale(1.);
  GDP_CHECK(GDP::process_signal(mesh, CGAL::make_property_map(with_holes), map, np) == GDP::error_invalid_signal);
  GDP_CHECK(GDP::process_signal(mesh, CGAL::make_property_map(with_holes), map, np.missing_values(true)) == GDP::ok);
  for(Vertex v : mesh.vertices())
    GDP_CHECK_NEAR(out[v], in[v], 2e-3); // harmonic inside, as a linear function is
  std::vector<double> infinite = in;
  infinite[3] = std::numeric_limits<double>::infinity();
  GDP_CHECK(GDP::process_signal(mesh, CGAL::make_property_map(infinite), map, np.missing_values(true))
            == GDP::error_invalid_signal);
}

std::vector<Vector> normals_of(const Mesh& mesh)
{
  std::vector<Vec> sums(mesh.number_of_vertices(), Vec(0, 0, 0));
  for(Face f : mesh.faces())
    for(Vertex v : corners(mesh, f))
      sums[v] += area_vector(mesh, f);
  std::vector<Vector> normals;
  for(const Vec& n : sums)
    normals.emplace_back(n.normalized().x(), n.normalized().y(), n.normalized().z());
  return normals;
}

double volume_of_first(const Mesh& mesh, std::size_t number_of_faces)
{
  double sum = 0;
  for(Face f : mesh.faces())
  {
    if(std::size_t(f) >= number_of_faces)
      break;
    const auto c = corners(mesh, f);
    sum += vec(mesh.point(c[0])).dot(vec(mesh.point(c[1])).cross(vec(mesh.point(c[2])))) / 6;
  }
  return sum;
}

double volume(const Mesh& mesh) { return volume_of_first(mesh, mesh.number_of_faces()); }

// A collinear face in a sphere: an edge whose opposite vertex is moved onto it.
Shape sphere_with_cap(double height)
{
  Shape shape = sphere(11, 0);
  const auto t = shape.triangles[shape.triangles.size() / 2];
  const Vec middle = (shape.points[t[0]] + shape.points[t[1]]) / 2;
  shape.points[t[2]] = middle + height * (shape.points[t[2]] - middle);
  return shape;
}

// The mesh's own normals move nothing, at creases and caps either; smoothed ones keep thin parts and throw no vertex
// away.
void test_own_normals()
{
  std::set<std::array<int, 3> > plate, slab;
  for(int i = 0; i < 40; ++i)
    for(int j = 0; j < 40; ++j)
    {
      slab.insert({{i, j, 0}});
      if(i < 6 && j < 6)
        plate.insert({{i, j, 0}});
    }
  const Shape two = cubes({{{0, 0, 0}}}, 6) + sphere(6).scaled(0.3).moved(Vec(3, 0, 0));
  for(const Shape& shape : {cubes(plate, 2), cubes(slab, 1).scaled(0.05), two, cubes({{{0, 0, 0}}}, 10),
                            sphere(8).noisy(0.05), sphere_with_cap(0), sphere_with_cap(1e-6), jittered_square(8)})
  {
    const Mesh before = mesh_of(shape);
    const std::vector<Vector> normals = normals_of(before);
    Mesh mesh = before;
    GDP_CHECK(GDP::fit_to_normals(mesh, CGAL::make_property_map(normals)) == GDP::ok);
    GDP_CHECK(distance(mesh, before) < 1e-9);
    mesh = before;
    GDP_CHECK(GDP::fit_to_normals(mesh, CGAL::make_property_map(normals),
                                  GDP::parameters::gradient_scale(0.).gradient_weight(1e-4))
              == GDP::ok);
    GDP_CHECK(distance(mesh, before) < 0.1);
    if(CGAL::is_closed(mesh))
      GDP_CHECK_NEAR(volume(mesh) / volume(before), 1, 1e-6); // a crease whose normals are smoothed bulges
    if(shape.points.size() == two.points.size())
      // each part's own
      GDP_CHECK_NEAR(volume_of_first(mesh, 6 * 2 * 36) / volume_of_first(before, 6 * 2 * 36), 1, 1e-6);
  }
  for(double height : {0., 1e-6, 1e-3})
    for(GDP::Normal_fit_kind kind : {GDP::Normal_fit_kind::FACES, GDP::Normal_fit_kind::EDGES})
      for(double scale : {0., 1.})
      {
        Mesh mesh = mesh_of(sphere_with_cap(height));
        const std::vector<Vector> normals = normals_of(mesh);
        GDP_CHECK(GDP::fit_to_normals(mesh, CGAL::make_property_map(normals),
          GDP::parameters::gradient_scale(scale).normal_fit_kind(kind)) == GDP::ok);
        double low = 1, high = 1;
        for(Vertex v : mesh.vertices())
        {
          low = (std::min)(low, vec(mesh.point(v)).norm());
          high = (std::max)(high, vec(mesh.point(v)).norm());
        }
        std::cout << "cap " << height << " kind " << int(kind) << " lambda " << scale << ": radius " << low << " to "
                  << high << std::endl;
        GDP_CHECK(low > 0.97 && high < 1.03);
      }
}

// Normals that are wanted are what the mesh has afterwards.
void test_wanted_normals()
{
  const Mesh smooth_mesh = mesh_of(sphere(12, 0.2)), rough = mesh_of(sphere(12, 0.2).noisy(0.01));
  std::vector<Vector> wanted;
  for(Vertex v : smooth_mesh.vertices())
    wanted.push_back(smooth_mesh.point(v) - CGAL::ORIGIN);
  const auto error = [&](const Mesh& mesh) {
    double sum = 0;
    const std::vector<Vector> normals = normals_of(mesh);
    for(Vertex v : mesh.vertices())
      sum += std::acos((std::min)(1., normals[v] * wanted[v])) / double(wanted.size());
    return sum;
  };
  for(GDP::Normal_fit_kind kind : {GDP::Normal_fit_kind::FACES, GDP::Normal_fit_kind::EDGES})
  {
    Mesh mesh = rough;
    GDP_CHECK(GDP::fit_to_normals(mesh, CGAL::make_property_map(wanted), GDP::parameters::normal_fit_kind(kind))
              == GDP::ok);
    std::cout << "normals of kind " << int(kind) << ": " << error(rough) << " -> " << error(mesh) << std::endl;
    GDP_CHECK(error(mesh) < 0.6 * error(rough));
  }
}

} // namespace

int main()
{
  test_not_shrinking();
  test_limits();
  test_missing_values();
  test_own_normals();
  test_wanted_normals();
  return GDP_TEST_RESULT();
}
