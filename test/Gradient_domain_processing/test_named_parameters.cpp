// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Named parameters: this package's and CGAL's chained in any order, handed to functions of this package and of others.

#include "test_meshes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/smooth.h>
#include <CGAL/Gradient_domain_processing/sharpen.h>

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <functional>
#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Simple_cartesian<double> K;
typedef CGAL::Surface_mesh<K::Point_3> Mesh;
typedef Mesh::Vertex_index Vertex;
typedef Mesh::Property_map<Vertex, K::Point_3> Points;

namespace {

template <class Tag, class NamedParameters>
auto value_of(const NamedParameters& np, Tag tag)
{
  return CGAL::parameters::get_parameter(np, tag);
}

// Every link of the chain is found again, whatever its place in it.
void check_lookup()
{
  using namespace CGAL::internal_np;
  const auto check = [](const auto& np) {
    GDP_CHECK(value_of(np, gradient_weight) == 0.25);
    GDP_CHECK(value_of(np, value_weight) == 3.);
    GDP_CHECK(value_of(np, number_of_iterations) == 7);
    GDP_CHECK(value_of(np, number_of_relaxation_steps) == 2);
    GDP_CHECK(value_of(np, area_normalization) == false);
  };
  check(GDP::parameters::gradient_weight(0.25)
          .number_of_iterations(7)
          .value_weight(3.)
          .number_of_relaxation_steps(2)
          .area_normalization(false));
  check(GDP::parameters::number_of_iterations(7)
          .number_of_relaxation_steps(2)
          .gradient_weight(0.25)
          .area_normalization(false)
          .value_weight(3.));
  check(GDP::parameters::with(CGAL::parameters::number_of_iterations(7).number_of_relaxation_steps(2))
          .area_normalization(false).gradient_weight(0.25).value_weight(3.));
  check(GDP::parameters::with(CGAL::parameters::number_of_relaxation_steps(2))
          .gradient_weight(0.25)
          .number_of_iterations(7)
          .value_weight(3.)
          .area_normalization(false));
  check(
    GDP::parameters::with(GDP::parameters::with(CGAL::parameters::number_of_relaxation_steps(2)).gradient_weight(0.25))
      .number_of_iterations(7)
      .value_weight(3.)
      .area_normalization(false));
  check(GDP::parameters::with(GDP::parameters::default_values())
          .gradient_weight(0.25)
          .number_of_iterations(7)
          .number_of_relaxation_steps(2)
          .value_weight(3.)
          .area_normalization(false));
  // the last one of a name counts
  check(GDP::parameters::gradient_weight(1e9).number_of_iterations(1).gradient_weight(0.25).number_of_iterations(7)
          .value_weight(3.).number_of_relaxation_steps(2).area_normalization(true).area_normalization(false));

  static_assert(
    GDP::internal::Has_parameter<gradient_weight_t,
                                 decltype(GDP::parameters::gradient_weight(1.).number_of_relaxation_steps(2))>::value,
    "");
  static_assert(
    !GDP::internal::Has_parameter<gradient_scale_t,
                                  decltype(GDP::parameters::gradient_weight(1.).number_of_relaxation_steps(2))>::value,
    "");
  static_assert(
    !GDP::internal::Has_parameter<gradient_weight_t, decltype(CGAL::parameters::number_of_relaxation_steps(2))>::value,
    "");
  static_assert(!GDP::internal::Has_parameter<gradient_weight_t, decltype(GDP::parameters::default_values())>::value,
                "");
}

struct Fixture
{
  Mesh tm = built<Mesh>(bumpy_patch(6, 6));
  Points other; // points of the user's: the mesh at twice the size
  Mesh::Property_map<Vertex, bool> constrained;

  Fixture()
  {
    other = tm.add_property_map<Vertex, K::Point_3>("v:other").first;
    constrained = tm.add_property_map<Vertex, bool>("v:constrained", false).first;
    for(Vertex v : vertices(tm))
    {
      other[v] = CGAL::ORIGIN + 2 * (tm.point(v) - CGAL::ORIGIN);
      constrained[v] = int(v) % 4 == 0;
    }
  }

  std::vector<Coordinates> other_points() const
  {
    std::vector<Coordinates> result;
    for(Vertex v : vertices(tm))
      result.push_back({{other[v].x(), other[v].y(), other[v].z()}});
    return result;
  }
};

// The same settings in several orders and in packs of several kinds move the same points to the same places.
void check_order()
{
  std::vector<std::vector<Coordinates> > results;
  const auto run = [&](const auto& make) {
    Fixture x;
    const std::vector<Coordinates> before = coordinates(x.tm);
    GDP_CHECK(GDP::smooth(x.tm, make(x)) == GDP::OK);
    GDP_CHECK(distance(before, coordinates(x.tm)) == 0); // they are the map's points that move
    results.push_back(x.other_points());
  };
  run([](const Fixture& x) { return GDP::parameters::gradient_weight(1e-3).vertex_point_map(x.other)
                                      .vertex_is_constrained_map(x.constrained).number_of_iterations(2); });
  run([](const Fixture& x) { return GDP::parameters::number_of_iterations(2).vertex_is_constrained_map(x.constrained)
                                      .gradient_weight(1e-3).vertex_point_map(x.other); });
  run([](const Fixture& x) {
    return GDP::parameters::with(CGAL::parameters::vertex_point_map(x.other).number_of_iterations(2))
      .gradient_weight(1e-3)
      .vertex_is_constrained_map(x.constrained);
  });
  GDP_CHECK(distance(results[0], results[1]) == 0);
  GDP_CHECK(distance(results[0], results[2]) == 0);

  const Fixture x;
  GDP_CHECK(distance(results[0], x.other_points()) > 1e-3);
  for(Vertex v : vertices(x.tm))
    if(x.constrained[v])
      GDP_CHECK(results[0][v] == x.other_points()[v]);
}

// Packs of CGAL alone, temporaries, lvalues and const lvalues.
void check_packs()
{
  Fixture a, b, c, d;
  GDP_CHECK(GDP::smooth(a.tm, CGAL::parameters::vertex_point_map(a.other).vertex_is_constrained_map(a.constrained))
            == GDP::OK);
  auto lvalue = GDP::parameters::vertex_is_constrained_map(b.constrained).vertex_point_map(b.other);
  GDP_CHECK(GDP::smooth(b.tm, lvalue) == GDP::OK);
  const auto const_lvalue = CGAL::parameters::vertex_point_map(c.other).vertex_is_constrained_map(c.constrained);
  GDP_CHECK(GDP::smooth(c.tm, const_lvalue) == GDP::OK);
  GDP_CHECK(distance(a.other_points(), b.other_points()) == 0);
  GDP_CHECK(distance(a.other_points(), c.other_points()) == 0);

  // a pack may be used again, and be the beginning of another
  const auto begun = GDP::parameters::vertex_is_constrained_map(d.constrained);
  GDP_CHECK(GDP::smooth(d.tm, begun.vertex_point_map(d.other)) == GDP::OK);
  GDP_CHECK(distance(a.other_points(), d.other_points()) == 0);
  GDP_CHECK(GDP::smooth(d.tm, begun) == GDP::OK);
}

struct Counting_visitor : GDP::Default_visitor
{
  int begun = 0, ended = 0;
  void stage_begins(GDP::Stage) { ++begun; }
  void stage_ends(GDP::Stage) { ++ended; }
};

void check_visitor()
{
  Fixture x;
  Counting_visitor visitor;
  GDP_CHECK(GDP::sharpen(x.tm, GDP::parameters::visitor(std::ref(visitor)).gradient_weight(1e-4)) == GDP::OK);
  GDP_CHECK(visitor.begun >= 6 && visitor.begun == visitor.ended);

  // by value, a copy is told
  const Counting_visitor copied;
  GDP_CHECK(GDP::sharpen(x.tm, GDP::parameters::visitor(copied).gradient_weight(1e-4)) == GDP::OK);
  GDP_CHECK(copied.begun == 0);
}

// Functions of Polygon_mesh_processing take what they know from packs of this package and ignore the rest.
void check_other_packages()
{
  Fixture x;
  const double area = PMP::area(x.tm);
  GDP_CHECK_NEAR(PMP::area(x.tm, GDP::parameters::vertex_point_map(x.other)), 4 * area, 1e-12 * area);
  GDP_CHECK_NEAR(PMP::area(x.tm, GDP::parameters::gradient_weight(1e-3).vertex_point_map(x.other).gradient_scale(2)),
                 4 * area, 1e-12 * area);
  GDP_CHECK_NEAR(PMP::area(x.tm, GDP::parameters::gradient_weight(1e-3)), area, 1e-12 * area);
  GDP_CHECK_NEAR(PMP::area(x.tm, GDP::parameters::with(CGAL::parameters::vertex_point_map(x.other)).value_weight(2)),
                 4 * area, 1e-12 * area);
  const auto lvalue = GDP::parameters::vertex_point_map(x.other).gradient_weight(1e-3);
  GDP_CHECK_NEAR(PMP::area(x.tm, lvalue), 4 * area, 1e-12 * area);

  // points after half a turn about the y-axis
  for(Vertex v : vertices(x.tm))
    x.other[v] = K::Point_3(-x.tm.point(v).x(), x.tm.point(v).y(), -x.tm.point(v).z());
  auto normals = x.tm.add_property_map<Vertex, K::Vector_3>("v:normal").first;
  auto others = x.tm.add_property_map<Vertex, K::Vector_3>("v:other_normal").first;
  PMP::compute_vertex_normals(x.tm, normals, GDP::parameters::gradient_weight(1.));
  PMP::compute_vertex_normals(x.tm, others,
                              GDP::parameters::gradient_weight(1.).vertex_point_map(x.other).geom_traits(K()));
  for(Vertex v : vertices(x.tm))
    GDP_CHECK_NEAR((others[v] - K::Vector_3(-normals[v].x(), normals[v].y(), -normals[v].z())).squared_length(), 0,
                   1e-20);
}

// Remeshing coarser: no pass leaves all vertices, one pass those that the pack constrains.
void check_remeshing()
{
  const auto removed = [](bool constrains, int passes) {
    Fixture x;
    if(!constrains)
      for(Vertex v : vertices(x.tm))
        x.constrained[v] = false;
    PMP::isotropic_remeshing(faces(x.tm), 0.4, x.tm, GDP::parameters::gradient_weight(1.).number_of_iterations(passes)
      .value_weight(2.).vertex_is_constrained_map(x.constrained).gradient_scale(3.));
    std::array<int, 2> count = {{0, 0}}; // of those that are constrained, and of the others
    for(int v = 0; v < 49; ++v)
      count[v % 4 == 0 ? 0 : 1] += x.tm.is_removed(Vertex(Mesh::size_type(v)));
    return count;
  };
  const std::array<int, 2> untouched = removed(true, 0), constrained = removed(true, 1), free = removed(false, 1);
  GDP_CHECK(untouched[0] == 0 && untouched[1] == 0);
  GDP_CHECK(constrained[0] == 0 && constrained[1] > 10);
  GDP_CHECK(free[0] > 0);
}

} // namespace

int main()
{
  check_lookup();
  check_order();
  check_packs();
  check_visitor();
  check_other_packages();
  check_remeshing();
  return GDP_TEST_RESULT();
}
