// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Mesh types, kernels and vertex point maps: the same surface gives the same result.

#include "test_meshes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/process_signal.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>

#include <cmath>
#include <map>
#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double> Double;
typedef CGAL::Simple_cartesian<float> Float;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
typedef CGAL::Exact_predicates_exact_constructions_kernel Epeck;

namespace {

// A patch whose coordinates are numbers of type float, so that every kernel begins with the same ones. They are rounded
// to multiples of 2^-20, since g++ 12 may drop a conversion to float and back when it vectorises.
Soup surface()
{
  const auto rounded = [](double x) { return std::round(std::ldexp(x, 20)) / std::ldexp(1., 20); };
  return transformed(bumpy_patch(8, 6), [&](const Coordinates& p) {
    return Coordinates{{rounded(p[0]), rounded(p[1]), rounded(p[2])}};
  });
}

std::vector<Coordinates> expected()
{
  auto tm = built<CGAL::Surface_mesh<Double::Point_3> >(surface());
  GDP_CHECK(GDP::smooth(tm) == GDP::OK);
  return coordinates(tm);
}

template <class Mesh>
void check_mesh(double tolerance)
{
  Mesh tm = built<Mesh>(surface());
  GDP_CHECK(distance(coordinates(tm), surface().points) == 0);
  GDP_CHECK(GDP::smooth(tm) == GDP::OK);
  GDP_CHECK(distance(coordinates(tm), expected()) <= tolerance);
}

// A signal kept beside the mesh, for any mesh.
template <class Mesh>
void check_signal(double tolerance)
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor Vertex;
  const Mesh tm = built<Mesh>(surface());
  std::map<Vertex, Double::Vector_3> in, out;
  const std::vector<Coordinates> points = coordinates(tm);
  std::size_t i = 0;
  for(Vertex v : vertices(tm))
  {
    in[v] = Double::Vector_3(points[i][0], points[i][1], points[i][2]);
    ++i;
  }
  out = in;
  GDP_CHECK(GDP::process_signal(tm, boost::make_assoc_property_map(in), boost::make_assoc_property_map(out))
            == GDP::OK);
  std::vector<Coordinates> values;
  for(Vertex v : vertices(tm))
    values.push_back({{out[v].x(), out[v].y(), out[v].z()}});
  GDP_CHECK(distance(values, expected()) <= tolerance);
  GDP_CHECK(distance(coordinates(tm), points) == 0);
}

// Points that the user keeps elsewhere, in a kernel that is not the mesh's.
struct Point_list_map
{
  typedef CGAL::Surface_mesh<Epick::Point_3>::Vertex_index key_type;
  typedef Double::Point_3 value_type;
  typedef Double::Point_3 reference; // made when asked for
  typedef boost::read_write_property_map_tag category;

  std::vector<Coordinates>* list;

  friend reference get(const Point_list_map& map, key_type v)
  {
    const Coordinates& p = map.list->at(v);
    return value_type(p[0], p[1], p[2]);
  }
  friend void put(const Point_list_map& map, key_type v, const value_type& p)
  {
    map.list->at(v) = {{p.x(), p.y(), p.z()}};
  }
};

void check_point_map()
{
  auto tm = built<CGAL::Surface_mesh<Epick::Point_3> >(scaled(surface(), 0)); // the mesh's own points are all one
  std::vector<Coordinates> list = surface().points;
  GDP_CHECK(GDP::smooth(tm, CGAL::parameters::vertex_point_map(Point_list_map{&list})) == GDP::OK);
  GDP_CHECK(distance(list, expected()) <= 1e-15);
  GDP_CHECK(distance(coordinates(tm), scaled(surface(), 0).points) == 0);

  // smoothed as a signal over the metric of the map's points
  list = surface().points;
  std::vector<Coordinates> result = list;
  const Point_list_map to_result{&result};
  const auto& const_mesh = tm;
  GDP_CHECK(GDP::process_signal(const_mesh, Point_list_map{&list}, to_result,
                                CGAL::parameters::vertex_point_map(Point_list_map{&list})) == GDP::OK);
  GDP_CHECK(distance(list, surface().points) == 0);
  GDP_CHECK(distance(result, expected()) <= 1e-15);
}

// Some faces of a mesh as a graph of their own: the result is that of a mesh of these faces, and the others are not
// looked at.
void check_filtered_graph()
{
  typedef CGAL::Surface_mesh<Double::Point_3> Mesh;
  typedef CGAL::Face_filtered_graph<Mesh> Filtered;
  Mesh tm = built<Mesh>(surface());
  std::vector<Mesh::Face_index> some;
  std::vector<Double::Point_3> points;
  for(auto v : tm.vertices())
    points.push_back(tm.point(v));
  const std::vector<Double::Point_3> before = points;
  std::vector<std::vector<std::size_t> > polygons;
  for(auto f : tm.faces())
    if(std::size_t(f) < tm.number_of_faces() / 2)
    {
      some.push_back(f);
      polygons.emplace_back();
      for(auto v : CGAL::vertices_around_face(tm.halfedge(f), tm))
        polygons.back().push_back(std::size_t(v));
    }
  Filtered filtered(tm, some);
  GDP_CHECK(GDP::smooth(filtered) == GDP::OK && GDP::smooth(points, polygons) == GDP::OK);
  std::size_t moved = 0;
  for(auto v : tm.vertices())
  {
    GDP_CHECK(CGAL::squared_distance(tm.point(v), points[std::size_t(v)]) < 1e-28);
    moved += tm.point(v) != before[std::size_t(v)];
  }
  GDP_CHECK(moved > 0 && moved < tm.number_of_vertices());
}

} // namespace

int main()
{
  GDP_CHECK(distance(expected(), surface().points) > 1e-3);
  check_mesh<CGAL::Surface_mesh<Epick::Point_3> >(1e-15);
  check_mesh<CGAL::Surface_mesh<Float::Point_3> >(1e-7); // the rounding of the output
  check_mesh<CGAL::Surface_mesh<Epeck::Point_3> >(1e-15);
  check_mesh<CGAL::Polyhedron_3<Epick> >(1e-14);
  check_signal<CGAL::Polyhedron_3<Double> >(1e-14);
  check_signal<CGAL::Surface_mesh<Float::Point_3> >(1e-14); // the signal keeps its digits
  check_point_map();
  check_filtered_graph();
  return GDP_TEST_RESULT();
}
