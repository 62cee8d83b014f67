// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Regions: what is outside or on the border of a face range does not move, to the bit; the rest solves the Dirichlet
// problem.

#include "test_energy.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/enhance_details.h>
#include <CGAL/Gradient_domain_processing/fit_to_gradients.h>
#include <CGAL/Gradient_domain_processing/fit_to_normals.h>
#include <CGAL/Gradient_domain_processing/process_signal.h>
#include <CGAL/Gradient_domain_processing/sharpen.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <limits>
#include <list>
#include <set>
#include <vector>

namespace GDP = CGAL::Gradient_domain_processing;
using namespace gdp_test;

typedef std::vector<Face> Region;

Mesh test_mesh() // a closed component and an open one
{
  return mesh_of(sphere(6).noisy(0.03) + jittered_square(6).noisy(0.02).moved(Vec(3, 0, 0)));
}

Vec centroid(const Mesh& mesh, Face f)
{
  Vec sum(0, 0, 0);
  for(Vertex v : corners(mesh, f))
    sum += vec(mesh.point(v)) / 3;
  return sum;
}

template <class Predicate>
Region faces_where(const Mesh& mesh, const Predicate& predicate)
{
  Region region;
  for(Face f : mesh.faces())
    if(predicate(centroid(mesh, f)))
      region.push_back(f);
  return region;
}

// The vertices all of whose faces are in the region, by definition.
std::vector<char> interior(const Mesh& mesh, const Region& region)
{
  const std::set<Face> inside(region.begin(), region.end());
  std::vector<char> result(mesh.number_of_vertices(), 1), has_face(mesh.number_of_vertices(), 0);
  for(Face f : mesh.faces())
    for(Vertex v : corners(mesh, f))
    {
      has_face[v] = 1;
      if(!inside.count(f))
        result[v] = 0;
    }
  for(std::size_t v = 0; v < result.size(); ++v)
    result[v] = result[v] && has_face[v];
  return result;
}

void check_that_the_rest_stays(const Mesh& mesh, const Mesh& before, const Region& region)
{
  const std::vector<char> is_inside = interior(before, region);
  int moved = 0, inside = 0;
  for(Vertex v : mesh.vertices())
  {
    inside += is_inside[v];
    moved += !same_bits(mesh.point(v), before.point(v));
    if(!is_inside[v])
      GDP_CHECK(same_bits(mesh.point(v), before.point(v)));
  }
  GDP_CHECK(moved >= inside * 9 / 10);
  GDP_CHECK(is_finite(mesh));
}

template <class Faces>
GDP::Error_code smooth(const Faces& region, Mesh& mesh, double weight = 0.01, double scale = 0)
{
  return GDP::smooth(region, mesh, GDP::parameters::gradient_weight(weight).gradient_scale(scale));
}

std::vector<Region> test_regions(const Mesh& mesh)
{
  const Face one = *mesh.faces().begin();
  std::vector<Region> regions = {
    Region(), Region(1, one),
    faces_where(mesh, [](const Vec& p) { return p.z() > 0.3; }),
    // three islands, one open
    faces_where(mesh, [](const Vec& p) { return std::abs(p.z()) > 0.6 || (p.x() > 3 && p.y() < 0.5); }),
    faces_where(mesh, [](const Vec& p) { return p.x() < 2; }), // one component
    Region(mesh.faces().begin(), mesh.faces().end()) };
  Region star; // of one vertex
  for(Face f : faces(mesh))
  {
    const auto c = corners(mesh, f);
    if(std::find(c.begin(), c.end(), Vertex(40)) != c.end())
      star.push_back(f);
  }
  regions.push_back(star);
  return regions;
}

// Against the Dirichlet problem in dense matrices, of the whole mesh.
void test_dense()
{
  const Mesh before = test_mesh();
  for(const Region& region : test_regions(before))
    for(double scale : {0., 2.5})
    {
      Mesh mesh = before;
      GDP_CHECK(smooth(region, mesh, 0.02, scale) == GDP::OK);
      check_that_the_rest_stays(mesh, before, region);

      Dense_energy energy(before, 1, 0.02 * total_area(before), scale);
      const std::vector<char> is_inside = interior(before, region);
      for(std::size_t v = 0; v < is_inside.size(); ++v)
        energy.is_fixed[v] = !is_inside[v];
      const Eigen::MatrixXd g = energy.minimum(positions(before));
      GDP_CHECK_NEAR((g - positions(mesh)).cwiseAbs().maxCoeff(), 0, 1e-12);
    }
}

void test_kinds_of_ranges()
{
  const Mesh before = test_mesh();
  const Region region = test_regions(before)[3];
  Mesh expected = before;
  GDP_CHECK(smooth(region, expected) == GDP::OK);
  GDP_CHECK(distance(expected, before) > 1e-3);

  Region shuffled = region;
  Random random;
  for(std::size_t i = shuffled.size() - 1; i > 0; --i)
    std::swap(shuffled[i], shuffled[random.below(int(i) + 1)]);
  Region doubled = shuffled;
  doubled.insert(doubled.end(), region.begin(), region.end());
  doubled.insert(doubled.begin(), 5, region.front());
  Mesh mesh = before;
  GDP_CHECK(smooth(shuffled, mesh) == GDP::OK);
  GDP_CHECK_NEAR(distance(mesh, expected), 0, 1e-14);
  mesh = before;
  GDP_CHECK(smooth(doubled, mesh) == GDP::OK);
  GDP_CHECK_NEAR(distance(mesh, expected), 0, 1e-14);
  mesh = before;
  GDP_CHECK(smooth(std::set<Face>(region.begin(), region.end()), mesh) == GDP::OK);
  GDP_CHECK_NEAR(distance(mesh, expected), 0, 1e-14);
  mesh = before;
  GDP_CHECK(smooth(std::list<Face>(doubled.begin(), doubled.end()), mesh) == GDP::OK);
  GDP_CHECK_NEAR(distance(mesh, expected), 0, 1e-14);

  // all of the mesh, as its own range, is as no region
  Mesh whole = before;
  GDP_CHECK(GDP::smooth(whole, GDP::parameters::gradient_weight(0.01).gradient_scale(0.)) == GDP::OK);
  mesh = before;
  GDP_CHECK(smooth(before.faces(), mesh) == GDP::OK);
  GDP_CHECK_NEAR(distance(mesh, whole), 0, 1e-13);
  GDP_CHECK(distance(mesh, before) > 1e-2);

  // a mesh of a single face, which has no outside
  Shape triangle;
  triangle.points = {Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0)};
  triangle.triangles = {{{0, 1, 2}}};
  Mesh a = mesh_of(triangle), b = a;
  GDP_CHECK(smooth(Region(1, Face(0)), a) == GDP::OK);
  GDP_CHECK(GDP::smooth(b, GDP::parameters::gradient_weight(0.01).gradient_scale(0.)) == GDP::OK);
  GDP_CHECK_NEAR(distance(a, b), 0, 1e-15);
  GDP_CHECK(!same_points(a, mesh_of(triangle)));
}

// Every function that takes a region.
void test_verbs()
{
  const Mesh before = test_mesh();
  Mesh normals_mesh = before;
  auto normals = normals_mesh.add_property_map<Vertex, Vector>("v:normal").first;
  for(Vertex v : before.vertices())
  {
    const Vec n = int(v) < 200 && before.point(v).x() < 2 ? vec(before.point(v)).normalized() : Vec(0, 0, 1);
    normals[v] = Vector(n.x(), n.y(), n.z());
  }
  for(const Region& region : test_regions(before))
  {
    Mesh mesh = before;
    GDP_CHECK(GDP::smooth(region, mesh, GDP::parameters::curvature_weight(0.02)) == GDP::OK);
    check_that_the_rest_stays(mesh, before, region);
    mesh = before;
    GDP_CHECK(GDP::sharpen(region, mesh) == GDP::OK);
    check_that_the_rest_stays(mesh, before, region);
    mesh = before;
    GDP_CHECK(GDP::enhance_details(region, mesh) == GDP::OK);
    check_that_the_rest_stays(mesh, before, region);
    mesh = before;
    GDP_CHECK(GDP::fit_to_normals(region, mesh, normals) == GDP::OK);
    check_that_the_rest_stays(mesh, before, region);
  }
}

void test_signals()
{
  Mesh mesh = test_mesh();
  auto in = mesh.add_property_map<Vertex, double>("v:in", 0.).first;
  auto out = mesh.add_property_map<Vertex, double>("v:out", 0.).first;
  auto gradients = mesh.add_property_map<Face, std::array<Vector, 1> >("f:v").first;
  Random random;
  for(Vertex v : mesh.vertices())
    in[v] = random();
  for(Face f : mesh.faces())
  {
    const double x = random(), y = random(), z = random();
    gradients[f] = {{Vector(x, y, z)}};
  }
  for(const Region& region : test_regions(mesh))
    for(bool fits : {false, true})
    {
      for(Vertex v : mesh.vertices())
        out[v] = 17;
      GDP_CHECK((fits ? GDP::fit_to_gradients(region, mesh, in, gradients, out, GDP::parameters::gradient_weight(0.05))
                      : GDP::process_signal(region, mesh, in, out, GDP::parameters::gradient_weight(0.05))) == GDP::OK);
      const std::vector<char> is_inside = interior(mesh, region);
      std::set<Vertex> of_region;
      for(Face f : region)
        for(Vertex v : corners(mesh, f))
          of_region.insert(v);

      Dense_energy energy(mesh, 1, 0.05 * total_area(mesh), 0);
      Eigen::MatrixXd f(mesh.number_of_vertices(), 1), covectors = Eigen::MatrixXd::Zero(2 * mesh.number_of_faces(), 1);
      for(Vertex v : mesh.vertices())
      {
        f(int(v), 0) = in[v];
        energy.is_fixed[v] = !is_inside[v];
      }
      if(fits)
        for(Face t : mesh.faces())
          covectors.middleRows(2 * t, 2) = energy.frame(t).transpose() * vec(gradients[t][0]);
      const Eigen::MatrixXd g = energy.minimum(f, covectors);
      for(Vertex v : mesh.vertices())
      {
        if(!of_region.count(v))
          GDP_CHECK(out[v] == 17); // not written
        else if(!is_inside[v])
          GDP_CHECK(same_bits(out[v], in[v]));
        else
          GDP_CHECK_NEAR(out[v], g(int(v), 0), 1e-11);
      }
    }
}

void test_errors()
{
  const Mesh before = test_mesh();
  const Region region = test_regions(before)[2];
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

  Mesh mesh = before;
  GDP_CHECK(smooth(region, mesh, -1) == GDP::ERROR_INVALID_WEIGHT);
  GDP_CHECK(smooth(region, mesh, nan) == GDP::ERROR_INVALID_WEIGHT);
  GDP_CHECK(smooth(region, mesh, 1, inf) == GDP::ERROR_INVALID_WEIGHT);
  GDP_CHECK(same_points(mesh, before));

  // a bad point in the region, on its border, and elsewhere: the area of the whole mesh counts
  for(Vertex v : before.vertices())
    if(int(v) % 5 == 0)
      for(double bad : {nan, inf})
      {
        Mesh broken = before;
        broken.point(v) = Point(0, bad, 1);
        Mesh copy = broken;
        GDP_CHECK(smooth(region, copy) == GDP::ERROR_INVALID_POINT);
        GDP_CHECK(same_points(copy, broken));
      }

  // a face that is not a triangle, inside and outside
  Mesh quad = before;
  const auto edge = quad.halfedge(region[5]);
  CGAL::Euler::join_face(edge, quad);
  const Region inside = faces_where(before, [](const Vec& p) { return p.z() > 0.3; });
  Region still;
  bool has_quad = false;
  for(Face f : inside)
    if(!quad.is_removed(f))
    {
      still.push_back(f);
      has_quad = has_quad || quad.degree(f) == 4;
    }
  GDP_CHECK(has_quad);
  Mesh copy = quad;
  GDP_CHECK(smooth(still, copy) == GDP::ok); // the quad takes part
  GDP_CHECK(!same_points(copy, quad));
  for(Vertex v : copy.vertices())
    if(quad.point(v).z() < 0.2)
      GDP_CHECK(copy.point(v) == quad.point(v));
}

int main()
{
  test_dense();
  test_kinds_of_ranges();
  test_verbs();
  test_signals();
  test_errors();
  return GDP_TEST_RESULT();
}
