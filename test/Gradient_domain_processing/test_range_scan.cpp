// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Figure 1 of the paper on a scan: a simulated one, so that its creases are known. A range scanner looks down on a part
// and measures heights on a grid that is turned against it, with noise along the line of sight. No vertex lies on a
// crease. With the name of a folder, the meshes of the first scan are written there.

#include "test_creases.h"

#include <CGAL/Surface_mesh/IO/OFF.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <set>
#include <string>
#include <vector>

using namespace gdp_test;

// Lengths are in spacings of the samples.
struct Surface_point
{
  double height;
  Vec normal;
  int face; // of the part
};

// A plate with a truncated pyramid, a dome, a groove and a roof on it: creases of 35 to 70 degrees, convex and concave,
// straight and round, between planes and curved faces. Nothing is so steep that it hides anything.
Surface_point part_at(double x, double y)
{
  constexpr double degree = pi / 180;
  const Vec up(0, 0, 1);
  { // a pyramid
    const double u = x + 15, v = y - 13, slope = std::tan(50 * degree), top = 9;
    const bool is_u = std::abs(u) > std::abs(v);
    const double height = slope * (15 - (std::max)(std::abs(u), std::abs(v)));
    const Vec outwards = is_u ? Vec(u > 0 ? 1 : -1, 0, 0) : Vec(0, v > 0 ? 1 : -1, 0);
    if(height > top)
      return {top, up, 1};
    if(height > 0)
      return {height, (up + slope * outwards).normalized(), (is_u ? 2 : 4) + ((is_u ? u : v) > 0)};
  }
  { // a dome
    const double rim = 12, radius = rim / std::sin(50 * degree), depth = radius * std::cos(50 * degree);
    const Vec p(x - 18, y - 15, 0);
    if(p.norm() < rim)
    {
      const double z = std::sqrt(radius * radius - p.squaredNorm());
      return {z - depth, (p + z * up) / radius, 6};
    }
  }
  { // a groove
    const double rim = 7, radius = rim / std::sin(45 * degree), height = radius * std::cos(45 * degree);
    const Vec p(0, y + 10, 0);
    if(p.norm() < rim)
    {
      const double z = std::sqrt(radius * radius - p.squaredNorm());
      return {height - z, (z * up - p) / radius, 7};
    }
  }
  { // a roof
    const double v = y + 27, slope = std::tan(35 * degree), height = slope * (8 - std::abs(v));
    if(height > 0)
      return {height, (up + slope * Vec(0, v > 0 ? 1 : -1, 0)).normalized(), v > 0 ? 8 : 9};
  }
  return {0, up, 0};
}

struct Scan
{
  Mesh clean, noisy;

  // where a crease passes: the faces to its two sides
  typedef std::array<std::vector<Face>, 2> Piece;
  std::vector<Piece> pieces;
  std::vector<Face> smooth_faces; // far from every crease and the border
  std::vector<Vec> true_area_vectors; // along the normals of the part, by face

  Scan(double noise, unsigned int seed)
  {
    sample(noise, seed);
    std::vector<Vec> centers;
    for(Face f : clean.faces())
    {
      const auto c = corners(clean, f);
      const Vec center = (vec(clean.point(c[0])) + vec(clean.point(c[1])) + vec(clean.point(c[2]))) / 3;
      centers.push_back(center);
      true_area_vectors.push_back(area_vector(clean, f).norm() * part_at(center.x(), center.y()).normal);
    }

    std::vector<double> distances(clean.number_of_faces(), std::numeric_limits<double>::infinity());
    for(auto e : clean.edges())
    {
      const Vec p = vec(clean.point(clean.vertex(e, 0))), q = vec(clean.point(clean.vertex(e, 1)));
      if(part_face(p) == part_face(q))
        continue;
      const Vec crossing = crease_between(p, q);
      std::vector<Face> near_faces;
      for(Face f : clean.faces())
      {
        const double distance = (centers[f] - crossing).head<2>().norm();
        distances[f] = (std::min)(distances[f], distance);
        if(distance < 2)
          near_faces.push_back(f);
      }
      add_piece(near_faces, part_face(p), part_face(q));
    }
    for(Face f : clean.faces())
      if(distances[f] > 5 && steps_to_border(f) >= 4)
        smooth_faces.push_back(f);
    GDP_CHECK(pieces.size() > 400 && smooth_faces.size() > 1000);
  }

  // root mean square of the angle between the normals and those of the part
  double residual_noise(const Mesh& mesh) const
  {
    double sum = 0;
    for(Face f : smooth_faces)
      sum += std::pow(angle(area_vector(mesh, f), true_area_vectors[f]), 2);
    return std::sqrt(sum / smooth_faces.size());
  }

  // mean absolute error of the angles between the two sides of a crease
  double crease_error(const Mesh& mesh) const
  {
    std::vector<Vec> area_vectors;
    for(Face f : mesh.faces())
      area_vectors.push_back(area_vector(mesh, f));
    double sum = 0;
    for(const Piece& piece : pieces)
      sum += std::abs(dihedral_angle(piece, area_vectors) - dihedral_angle(piece, true_area_vectors));
    return sum / pieces.size();
  }

private:
  static constexpr int n = 72; // samples a side

  static int part_face(const Vec& p) { return part_at(p.x(), p.y()).face; }

  void sample(double noise, unsigned int seed)
  {
    Random random(seed);
    Shape shape = grid(n - 1, n - 1, [&](double u, double v) {
      const double a = (n - 1) * (u - 0.5) + 0.2 * random(), b = (n - 1) * (v - 0.5) + 0.2 * random(), turn = 0.35;
      const double x = std::cos(turn) * a - std::sin(turn) * b, y = std::sin(turn) * a + std::cos(turn) * b;
      return Vec(x, y, part_at(x, y).height);
    });
    const auto rounded = [](double z) { return 0.05 * std::round(z / 0.05); }; // as a scanner's numbers are
    const Shape measured = shape.mapped([&](const Vec& p) {
      double normal_deviate = 0;
      for(int i = 0; i < 12; ++i)
        normal_deviate += random() / 2;
      return Vec(p.x(), p.y(), rounded(p.z() + noise * normal_deviate));
    });
    // all that a scanner knows: the shorter diagonal of a square of its grid
    for(int i = 0; i < n - 1; ++i)
      for(int j = 0; j < n - 1; ++j)
      {
        const int a = i * n + j, b = a + n, c = b + 1, d = a + 1;
        const bool is_ac =
          (measured.points[a] - measured.points[c]).norm() < (measured.points[b] - measured.points[d]).norm();
        shape.triangles[2 * (i * (n - 1) + j)] = {{a, b, is_ac ? c : d}};
        shape.triangles[2 * (i * (n - 1) + j) + 1] = {{is_ac ? a : b, c, d}};
      }
    clean = mesh_of(shape);
    shape.points = measured.points;
    noisy = mesh_of(shape);
  }

  static Vec crease_between(Vec p, Vec q)
  {
    const int face = part_face(p);
    for(int step = 0; step < 30; ++step)
    {
      const Vec middle = (p + q) / 2;
      (part_face(middle) == face ? p : q) = middle;
    }
    return p;
  }

  int steps_to_border(Face f) const
  {
    int steps = n;
    for(Vertex v : corners(clean, f))
    {
      const int i = int(v) / n, j = int(v) % n;
      steps = (std::min)({steps, i, j, n - 1 - i, n - 1 - j});
    }
    return steps;
  }

  // faces that reach across the crease belong to neither side; near a third face of the part there is no piece
  void add_piece(const std::vector<Face>& near_faces, int first, int second)
  {
    Piece piece;
    for(Face f : near_faces)
    {
      std::set<int> part_faces;
      for(Vertex v : corners(clean, f))
        part_faces.insert(part_face(vec(clean.point(v))));
      for(int face : part_faces)
        if(face != first && face != second)
          return;
      if(steps_to_border(f) < 3)
        return;
      if(part_faces.size() == 1)
        piece[*part_faces.begin() == second].push_back(f);
    }
    if(piece[0].size() >= 2 && piece[1].size() >= 2)
      pieces.push_back(piece);
  }

  static double dihedral_angle(const Piece& piece, const std::vector<Vec>& area_vectors)
  {
    Vec sums[2] = {Vec(0, 0, 0), Vec(0, 0, 0)};
    for(int side : {0, 1})
      for(Face f : piece[side])
        sums[side] += area_vectors[f];
    return angle(sums[0], sums[1]);
  }
};

Smoothed_part test_scan(const std::string& name, const Scan& scan)
{
  const double remaining = 0.25;
  Filter filter;
  filter.curvature_weight = 0.2;
  filter.presmoothing_weight = 3e-5;
  filter.passes = 3;
  filter.border_condition = GDP::Border_condition::ALONG_BORDER;
  std::cout << name << ": normals off by " << scan.residual_noise(scan.noisy) << " degrees, to be " << remaining
            << " of that; dihedral angles off by " << scan.crease_error(scan.noisy) << std::endl;
  const Smoothed_part result = test_creases(name, scan, remaining, filter);
  const double edge_aware = scan.crease_error(result.edge_aware);

  // more and smaller steps do not make up for a metric
  filter.kind = Kind::EMBEDDING;
  filter.passes = 8;
  const double isotropic = scan.crease_error(smoothed_to(scan, remaining * scan.residual_noise(scan.noisy), filter));
  std::cout << "isotropic, in eight passes: " << isotropic << " (edge aware is " << isotropic / edge_aware
            << " times better)" << std::endl;
  GDP_CHECK(isotropic > 2 * edge_aware);

  // what is measured has no error of its own
  GDP_CHECK(scan.crease_error(scan.clean) < 0.1);
  GDP_CHECK(scan.crease_error(scan.noisy) > 2);
  return result;
}

void write(const std::string& path, const Mesh& mesh)
{
  GDP_CHECK(CGAL::IO::write_OFF(path, mesh, CGAL::parameters::stream_precision(17)));
}

int main(int argc, char* argv[])
{
  const Scan scan(0.1, 1);
  const Smoothed_part result = test_scan("scan", scan);
  test_scan("noisier scan", Scan(0.15, 2));
  if(argc > 1)
  {
    const std::string folder = argv[1];
    write(folder + "/noisy.off", scan.noisy);
    write(folder + "/isotropic.off", result.isotropic);
    write(folder + "/edge_aware.off", result.edge_aware);
    write(folder + "/anisotropic.off", result.anisotropic);
  }
  return GDP_TEST_RESULT();
}
