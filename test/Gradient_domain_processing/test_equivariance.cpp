// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Results move with the mesh: rotation, translation, scale, another order of vertices and faces. lambda = 1 changes
// nothing.

#include "test_meshes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/smooth.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <string>
#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double> K;
typedef CGAL::Surface_mesh<K::Point_3> Mesh;

namespace {

struct Setting
{
  GDP::Curvature_metric_kind kind = GDP::Curvature_metric_kind::EMBEDDING;
  GDP::Curvature_estimator estimator = GDP::Curvature_estimator::NORMALS;
  double lambda = 0;
  bool relative = true;
  double squared_scale = 1; // of weights that are absolute
};

std::vector<Coordinates> filtered(const Soup& soup, const Setting& s)
{
  Mesh tm = built<Mesh>(soup);
  // those of a mesh of area 10, if absolute
  const double unit = s.relative ? 1 : 10 * s.squared_scale;
  GDP_CHECK(GDP::smooth(tm, GDP::parameters::gradient_weight(1e-3 * unit)
                              .gradient_scale(s.lambda)
                              .area_normalization(s.relative)
                              .curvature_metric_kind(s.kind)
                              .curvature_estimator(s.estimator)
                              .curvature_weight(0.05 * unit)
                              .presmoothing_weight(1e-4 * unit))
            == GDP::OK);
  return coordinates(tm);
}

Soup with_points(Soup soup, const std::vector<Coordinates>& points)
{
  soup.points = points;
  return soup;
}

void check_identity(const Soup& soup, Setting s)
{
  s.lambda = 1;
  for(double factor : {1., 1e-8, 1e8})
    GDP_CHECK(distance(filtered(scaled(soup, factor), s), scaled(soup, factor).points) <= 1e-15 * factor);
  s.lambda = 0;
  GDP_CHECK(distance(filtered(soup, s), soup.points) > 1e-3); // while without it, it moves
}

// `tolerance` relative to the extent of the mesh, which is near one.
void check_equivariance(const Soup& soup, const Setting& s, double tolerance)
{
  const std::vector<Coordinates> result = filtered(soup, s);
  const Soup expected = with_points(soup, result);

  GDP_CHECK(distance(filtered(rotated(soup), s), rotated(expected).points) <= tolerance);

  // the digits that the translated coordinates lack are gone
  for(double by : {1., 1e3})
  {
    const Coordinates offset = {{by, -2 * by, 0.7 * by}};
    GDP_CHECK(distance(filtered(translated(soup, offset), s), translated(expected, offset).points) <= by * tolerance);
  }

  for(double factor : {1e-60, 1e-5, 3., 1e5, 1e60})
  {
    Setting at_scale = s;
    at_scale.squared_scale = factor * factor;
    GDP_CHECK(distance(filtered(scaled(soup, factor), at_scale), scaled(expected, factor).points)
              <= factor * tolerance);
  }

  for(unsigned int seed : {1u, 2u})
  {
    std::vector<int> place;
    const std::vector<Coordinates> moved = filtered(permuted(soup, seed, place), s);
    std::vector<Coordinates> back;
    for(int i : place)
      back.push_back(moved[i]);
    GDP_CHECK(distance(back, result) <= tolerance);
  }
}

// Absolute weights are those relative to the area times the area.
void check_units(const Soup& soup)
{
  Mesh relative = built<Mesh>(soup), absolute = relative;
  const double area = 6;
  GDP_CHECK(GDP::smooth(relative, GDP::parameters::gradient_weight(1e-3).area_normalization(true)) == GDP::OK);
  GDP_CHECK(GDP::smooth(absolute, GDP::parameters::gradient_weight(1e-3 * area).area_normalization(false)) == GDP::OK);
  GDP_CHECK(distance(coordinates(relative), coordinates(absolute)) <= 1e-14);
  // and relative is the default
  Mesh plain = built<Mesh>(soup);
  GDP_CHECK(GDP::smooth(plain, GDP::parameters::gradient_weight(1e-3)) == GDP::OK);
  GDP_CHECK(distance(coordinates(plain), coordinates(relative)) == 0);
}

} // namespace

int main()
{
  check_units(box(4)); // the unit cube, of area 6
  typedef GDP::Curvature_metric_kind Kind;
  for(const Soup& soup : {bumpy_sphere(3), bumpy_patch(12, 9)})
    for(bool relative : {true, false})
      for(Kind kind :
          {Kind::EMBEDDING, Kind::EDGE_AWARE, Kind::ANISOTROPIC, Kind::PRESERVE_CONVEX, Kind::PRESERVE_CONCAVE})
        for(double lambda : {0., 2.})
        {
          Setting s;
          s.kind = kind;
          s.relative = relative;
          s.lambda = lambda;
          check_identity(soup, s);
          check_equivariance(soup, s, 2e-13);
        }

  // fitting jets loses some digits more
  Setting jets;
  jets.kind = Kind::ANISOTROPIC;
  jets.estimator = GDP::Curvature_estimator::JETS;
  check_identity(bumpy_sphere(3), jets);
  check_equivariance(bumpy_sphere(3), jets, 1e-11);
  return GDP_TEST_RESULT();
}
