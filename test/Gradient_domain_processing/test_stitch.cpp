// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Signals of several patches fused: the seam vanishes, the gradients stay, and what fits is left alone.

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/stitch.h>

#include <iostream>
#include <vector>

namespace GDP = CGAL::Gradient_domain_processing;
using namespace gdp_test;

// A mesh whose vertices belong to patches, with the measures of the seam.
struct Patches
{
  Mesh mesh;
  Mesh::Property_map<Vertex, int> patch;

  template <class Patch_of>
  Patches(const Shape& shape, const Patch_of& patch_of)
    : mesh(mesh_of(shape)), patch(mesh.add_property_map<Vertex, int>("v:patch", 0).first)
  {
    for(Vertex v : mesh.vertices())
      patch[v] = patch_of(vec(mesh.point(v)));
  }

  bool is_seam(Face f) const
  {
    const auto c = corners(mesh, f);
    return patch[c[0]] != patch[c[1]] || patch[c[0]] != patch[c[2]];
  }

  // the largest step along an edge from patch to patch, beyond that of the signal without offsets
  template <class Map, class Smooth>
  double jump(Map g, const Smooth& smooth) const
  {
    double largest = 0;
    for(auto e : mesh.edges())
    {
      const Vertex v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
      if(patch[v] != patch[w])
        largest =
          (std::max)(largest, std::abs((g[v] - smooth(vec(mesh.point(v)))) - (g[w] - smooth(vec(mesh.point(w))))));
    }
    return largest;
  }

  Vec gradient(Face f, const Mesh::Property_map<Vertex, double>& g) const
  {
    const auto c = corners(mesh, f);
    Eigen::Matrix<double, 3, 3> rows;
    for(int i = 0; i < 2; ++i)
      rows.row(i) = (vec(mesh.point(c[i + 1])) - vec(mesh.point(c[0]))).transpose();
    rows.row(2) = area_vector(mesh, f).normalized().transpose();
    return rows.inverse() * Vec(g[c[1]] - g[c[0]], g[c[2]] - g[c[0]], 0);
  }

  // the change of the gradients relative to the gradients, in the mean of squares, three rings of faces from the seam
  // on
  double gradient_change(const Mesh::Property_map<Vertex, double>& f, const Mesh::Property_map<Vertex, double>& g) const
  {
    std::vector<int> ring(mesh.number_of_vertices(), 1000);
    for(Face t : mesh.faces())
      if(is_seam(t))
        for(Vertex v : corners(mesh, t))
          ring[v] = 0;
    for(int pass = 0; pass < 4; ++pass)
      for(auto h : mesh.halfedges())
        if(ring[mesh.source(h)] == pass)
          ring[mesh.target(h)] = (std::min)(ring[mesh.target(h)], pass + 1);
    double change = 0, all = 0;
    for(Face t : mesh.faces())
    {
      int nearest = 1000;
      for(Vertex v : corners(mesh, t))
        nearest = (std::min)(nearest, ring[v]);
      if(nearest < 3)
        continue;
      change += area_vector(mesh, t).norm() * (gradient(t, g) - gradient(t, f)).squaredNorm();
      all += area_vector(mesh, t).norm() * gradient(t, f).squaredNorm();
    }
    return std::sqrt(change / all);
  }
};

// One smooth signal with an offset between patches comes back seamless.
template <class Patch_of, class Smooth>
void check_offset(const char* name, const Shape& shape, const Patch_of& patch_of, const Smooth& smooth, double offset)
{
  Patches patches(shape, patch_of);
  auto f = patches.mesh.add_property_map<Vertex, double>("v:f", 0.).first;
  auto g = patches.mesh.add_property_map<Vertex, double>("v:g", 0.).first;
  for(Vertex v : patches.mesh.vertices())
    f[v] = smooth(vec(patches.mesh.point(v))) + offset * patches.patch[v];
  GDP_CHECK(GDP::stitch(patches.mesh, patches.patch, f, g) == GDP::OK);
  const double jump = patches.jump(g, smooth) / std::abs(offset), change = patches.gradient_change(f, g);
  std::cout << name << ": jump " << jump << " of the offset (was " << patches.jump(f, smooth) / std::abs(offset)
            << "), gradients changed by " << change << std::endl;
  GDP_CHECK(patches.jump(f, smooth) > 0.99 * std::abs(offset));
  GDP_CHECK(jump < 0.01);
  GDP_CHECK(change < 0.01);
}

const auto wave = [](const Vec& p) {
  return std::sin(3 * p.x() + 0.3) + 0.5 * std::cos(4 * p.y() - p.x()) + 0.3 * p.z();
};

void test_offsets()
{
  const Shape flat = square(128), ball = sphere(48, 0.2);
  const auto halves = [](const Vec& p) { return int(p.x() > 0.48); };
  const auto thirds = [](const Vec& p) { return p.x() > 0.62 ? 2 : int(p.x() > 0.3); };
  const auto hemispheres = [](const Vec& p) { return int(p.z() > 0.1); };
  for(double offset : {1.5, -5., 100.})
  {
    check_offset(
      "square, two patches", flat, halves, [](const Vec& p) { return std::cos(p.y()) + 0.5 * std::sin(2 * p.x()); },
      offset);
    check_offset(
      "square, three patches", flat, thirds, [](const Vec& p) { return 0.3 * std::cos(p.y()) + p.x(); }, offset);
    check_offset(
      "sphere, two patches", ball, hemispheres, [](const Vec& p) { return 0.3 * p.z() + 0.05 * p.x() * p.x(); },
      offset);
  }
}

// The mean of the offset is what the values decide.
void test_constants()
{
  Patches patches(square(20), [](const Vec& p) { return int(p.x() > 0.51); });
  auto f = patches.mesh.add_property_map<Vertex, double>("v:f", 0.).first;
  auto g = patches.mesh.add_property_map<Vertex, double>("v:g", 0.).first;
  for(Vertex v : patches.mesh.vertices())
    f[v] = patches.patch[v];
  GDP_CHECK(GDP::stitch(patches.mesh, patches.patch, f, g) == GDP::OK);
  double mean = 0; // the integral of the hat functions
  for(Face t : patches.mesh.faces())
    for(Vertex v : corners(patches.mesh, t))
      mean += area_vector(patches.mesh, t).norm() / 3 * f[v];
  for(Vertex v : patches.mesh.vertices())
    GDP_CHECK_NEAR(g[v], mean, 1e-3);
}

// What fits is returned: a single patch to the bit, two patches of one continuous signal too.
void test_equal_patches()
{
  for(const Shape& shape : {square(24), sphere(10)})
    for(int number : {1, 2, 3})
    {
      Patches patches(shape, [&](const Vec& p) { return int(std::floor((p.y() + 1) / 2.001 * number)); });
      auto f = patches.mesh.add_property_map<Vertex, double>("v:f", 0.).first;
      auto g = patches.mesh.add_property_map<Vertex, double>("v:g", 0.).first;
      for(Vertex v : patches.mesh.vertices())
        f[v] = wave(vec(patches.mesh.point(v)));
      GDP_CHECK(GDP::stitch(patches.mesh, patches.patch, f, g) == GDP::OK);
      for(Vertex v : patches.mesh.vertices())
        GDP_CHECK(same_bits(g[v], f[v]));

      // constants, too
      for(Vertex v : patches.mesh.vertices())
        f[v] = 0.1;
      GDP_CHECK(GDP::stitch(patches.mesh, patches.patch, f, g) == GDP::OK);
      for(Vertex v : patches.mesh.vertices())
        GDP_CHECK(same_bits(g[v], f[v]));
    }

  // a seam that fits beside one that does not: only the second is closed
  Patches patches(square(64), [](const Vec& p) { return p.x() > 0.7 ? 2 : int(p.x() > 0.4); });
  auto f = patches.mesh.add_property_map<Vertex, double>("v:f", 0.).first;
  auto g = patches.mesh.add_property_map<Vertex, double>("v:g", 0.).first;
  for(Vertex v : patches.mesh.vertices())
    f[v] = wave(vec(patches.mesh.point(v))) + 5 * (patches.patch[v] == 2);
  GDP_CHECK(GDP::stitch(patches.mesh, patches.patch, f, g) == GDP::OK);
  double change = 0, all = 0;
  for(Face t : patches.mesh.faces())
  {
    const auto c = corners(patches.mesh, t);
    const double x = patches.mesh.point(c[0]).x();
    if(patches.is_seam(t) && x < 0.6)
    {
      change += (patches.gradient(t, g) - patches.gradient(t, f)).squaredNorm();
      all += patches.gradient(t, f).squaredNorm();
    }
  }
  std::cout << "the seam that fits: gradients changed by " << std::sqrt(change / all) << std::endl;
  GDP_CHECK(std::sqrt(change / all) < 0.05);
}

// Two photographs of different exposure.
void test_colors()
{
  typedef CGAL::IO::Color Color;
  Patches patches(square(48), [](const Vec& p) { return int(p.x() + 0.2 * p.y() > 0.6); });
  auto f = patches.mesh.add_property_map<Vertex, Color>("v:f").first;
  auto g = patches.mesh.add_property_map<Vertex, Color>("v:g").first;
  for(Vertex v : patches.mesh.vertices())
  {
    const Vec p = vec(patches.mesh.point(v));
    const int offset = 40 * patches.patch[v];
    f[v] = Color((unsigned char)(80 + 30 * std::sin(2 * p.y()) + offset), (unsigned char)(100 + 20 * p.y() - offset),
                 (unsigned char)(90 + offset / 2), 255);
  }
  GDP_CHECK(GDP::stitch(patches.mesh, patches.patch, f, g) == GDP::OK);
  int before = 0, after = 0;
  for(auto e : patches.mesh.edges())
  {
    const Vertex v = patches.mesh.vertex(e, 0), w = patches.mesh.vertex(e, 1);
    if(patches.patch[v] != patches.patch[w])
      for(int i = 0; i < 4; ++i)
      {
        before = (std::max)(before, std::abs(int(f[v][i]) - int(f[w][i])));
        after = (std::max)(after, std::abs(int(g[v][i]) - int(g[w][i])));
      }
  }
  std::cout << "colors: jump " << before << " before, " << after << " after" << std::endl;
  GDP_CHECK(before >= 40);
  GDP_CHECK(after <= 2); // of which one is rounding
  for(Vertex v : patches.mesh.vertices())
    GDP_CHECK(g[v].alpha() == 255);

  for(Vertex v : patches.mesh.vertices())
    f[v] = Color(1, 2, 3, 4);
  GDP_CHECK(GDP::stitch(patches.mesh, patches.patch, f, g) == GDP::OK);
  for(Vertex v : patches.mesh.vertices())
    GDP_CHECK(g[v] == Color(1, 2, 3, 4));
}

// Positions: two scans of a surface, one of them lifted, with noise of their own.
void test_positions()
{
  const int n = 48;
  const double lift = 0.5;
  const auto height = [](const Vec& p) { return 0.03 * std::sin(4 * p.y()) + 0.02 * std::cos(6 * p.x()); };
  const Shape shape = square(n).mapped([&](const Vec& p) { return Vec(p.x(), p.y(), height(p)); });
  Patches patches(shape, [](const Vec& p) { return int(p.x() > 0.51); });
  Mesh& mesh = patches.mesh;
  for(Vertex v : mesh.vertices())
    mesh.point(v) = mesh.point(v) + Vector(0, 0, lift * patches.patch[v]);

  // the layout that both share is the domain, the lifted heights are the signal
  auto flat = mesh.add_property_map<Vertex, Point>("v:flat").first;
  auto out = mesh.add_property_map<Vertex, Point>("v:out").first;
  for(Vertex v : mesh.vertices())
    flat[v] = Point(mesh.point(v).x(), mesh.point(v).y(), 0);
  auto z_in = mesh.add_property_map<Vertex, double>("v:z").first;
  for(Vertex v : mesh.vertices())
    z_in[v] = mesh.point(v).z();
  GDP_CHECK(GDP::stitch(mesh, patches.patch, z_in, z_in, GDP::parameters::vertex_point_map(flat)) == GDP::OK);
  const auto flat_height = [&](const Vec& p) { return height(Vec(p.x(), p.y(), 0)); };
  GDP_CHECK(patches.jump(z_in, flat_height) < 0.01 * lift);

  // positions as one signal of three channels; along x the seam loses its width, and no more
  GDP_CHECK(GDP::stitch(mesh, patches.patch, mesh.points(), out, GDP::parameters::vertex_point_map(flat)) == GDP::OK);
  for(auto e : mesh.edges())
  {
    const Vertex v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
    if(patches.patch[v] == patches.patch[w])
      continue;
    GDP_CHECK(std::abs(out[v].z() - out[w].z()) < 0.01 * lift);
    GDP_CHECK(std::abs(out[v].x() - out[w].x()) < 1.1 / n);
  }
}

// Of two seams, the one in the region goes; vertices that have a face outside keep their values, to the bit.
void test_region()
{
  const double offset = 20;
  Patches patches(square(40), [](const Vec& p) { return int(p.x() > 0.26) + int(p.x() > 0.76); });
  Mesh& mesh = patches.mesh;
  auto f = mesh.add_property_map<Vertex, double>("v:f").first;
  for(Vertex v : mesh.vertices())
    f[v] = wave(vec(mesh.point(v))) + offset * patches.patch[v];
  std::vector<Face> region;
  std::vector<char> has_face_inside(mesh.number_of_vertices(), 0), has_face_outside = has_face_inside;
  for(Face t : mesh.faces())
  {
    const bool is_inside = vec(mesh.point(corners(mesh, t)[0])).x() < 0.5;
    if(is_inside)
      region.push_back(t);
    for(Vertex v : corners(mesh, t))
      (is_inside ? has_face_inside : has_face_outside)[v] = 1;
  }
  auto g = mesh.add_property_map<Vertex, double>("v:g", -1.).first;
  GDP_CHECK(GDP::stitch(std::vector<Face>(), mesh, patches.patch, f, g, GDP::parameters::gradient_weight(1))
            == GDP::OK);
  GDP_CHECK(GDP::stitch(region, mesh, patches.patch, f, g) == GDP::OK);

  double jump = 0;
  for(auto e : mesh.edges())
  {
    const Vertex v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
    if(patches.patch[v] + patches.patch[w] == 1)
      jump = (std::max)(jump, std::abs((g[v] - wave(vec(mesh.point(v)))) - (g[w] - wave(vec(mesh.point(w))))));
  }
  std::cout << "a region: jump " << jump / offset << " of the offset" << std::endl;
  GDP_CHECK(jump < 0.01 * offset);
  for(Vertex v : mesh.vertices())
    if(has_face_outside[v])
      GDP_CHECK(g[v] == (has_face_inside[v] ? f[v] : -1));
}

int main()
{
  test_offsets();
  test_constants();
  test_equal_patches();
  test_colors();
  test_positions();
  test_region();
  return GDP_TEST_RESULT();
}
