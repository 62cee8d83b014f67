// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The arrays that a mesh is read into: they hold the mesh, and neighbors lie close together, whatever its own order is.

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/internal/mesh/read_graph.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <vector>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;
namespace internal = CGAL::Gradient_domain_processing::internal;

typedef internal::Surface_elements<Mesh> Elements;
typedef internal::Indexed_triangles Arrays;

// The vertices and the faces in an order drawn by lot.
Shape shuffled(const Shape& shape)
{
  std::mt19937 random(5);
  std::vector<int> place(shape.points.size());
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin(), place.end(), random);
  Shape result = shape;
  for(std::size_t v = 0; v < place.size(); ++v)
    result.points[place[v]] = shape.points[v];
  std::shuffle(result.triangles.begin(), result.triangles.end(), random);
  for(auto& t : result.triangles)
    for(int& v : t)
      v = place[v];
  return result;
}

double mean_span(const std::vector<std::array<int, 3> >& triangles)
{
  double sum = 0;
  for(const auto& t : triangles)
    sum += (std::max)({t[0], t[1], t[2]}) - (std::min)({t[0], t[1], t[2]});
  return sum / double(triangles.size());
}

void holds(const Mesh& mesh, const std::set<Face>& faces, const Elements& elements, const Arrays& arrays)
{
  GDP_CHECK(std::set<Face>(elements.faces.begin(), elements.faces.end()) == faces
            && elements.faces.size() == faces.size());
  GDP_CHECK(std::set<Vertex>(elements.vertices.begin(), elements.vertices.end()).size() == elements.vertices.size());
  GDP_CHECK(arrays.triangles.size() == elements.faces.size() && arrays.points.size() == elements.vertices.size());
  GDP_CHECK(arrays.is_on_border.size() == elements.vertices.size());

  std::size_t wrong = 0;
  for(std::size_t v = 0; v < arrays.points.size(); ++v)
  {
    const bool is_used = arrays.corners.size(int(v)) > 0; // else it lies anywhere on the surface
    wrong += is_used && arrays.unit() * arrays.points[v] != vec(mesh.point(elements.vertices[v]));
    wrong += !is_used && arrays.points[v].cwiseAbs().maxCoeff() > 4;
    wrong += is_used && (arrays.is_on_border[v] != 0) != mesh.is_border(elements.vertices[v]);
    for(const int* c = arrays.corners.begin(int(v)); c != arrays.corners.end(int(v)); ++c)
      wrong += arrays.triangles[*c / 3][*c % 3] != int(v) || (c + 1 < arrays.corners.end(int(v)) && c[1] <= c[0]);
  }
  for(std::size_t f = 0; f < arrays.triangles.size(); ++f)
  {
    const auto h = mesh.halfedge(elements.faces[f]);
    wrong += elements.vertices[arrays.triangles[f][0]] != mesh.source(h);
    wrong += elements.vertices[arrays.triangles[f][1]] != mesh.target(h);
    wrong += elements.vertices[arrays.triangles[f][2]] != mesh.target(mesh.next(h));
  }
  GDP_CHECK(wrong == 0);
}

void test_whole(const Shape& shape, bool parallel)
{
  Mesh mesh = mesh_of(shape);
  mesh.add_vertex(Point(9, 9, 9)); // without a face
  mesh.remove_vertex(mesh.add_vertex(Point(8, 8, 8)));
  CGAL::Euler::remove_face(mesh.halfedge(Face(7)), mesh); // indices with gaps
  Elements elements;
  Arrays arrays;
  internal::Reading reading;
  reading.parallel = parallel;
  GDP_CHECK(internal::read_surface(mesh, mesh.points(), CGAL::parameters::default_values(), reading, elements, arrays)
            == GDP::ok);
  holds(mesh, std::set<Face>(mesh.faces().begin(), mesh.faces().end()), elements, arrays);
  GDP_CHECK(elements.vertices.size() == mesh.number_of_vertices());
  GDP_CHECK(mean_span(arrays.triangles) < 8 * std::sqrt(double(arrays.points.size())));
}

void test_region(const Shape& shape)
{
  const Mesh mesh = mesh_of(shape);
  std::set<Face> faces;
  for(Face f : mesh.faces())
    if(vec(mesh.point(mesh.source(mesh.halfedge(f))))[0] < 0.4)
      faces.insert(f);
  std::vector<Face> twice(faces.begin(), faces.end());
  twice.insert(twice.end(), faces.begin(), faces.end());
  Elements elements;
  Arrays arrays;
  std::vector<char> is_fixed;
  internal::Reading reading;
  GDP_CHECK(internal::read_region(twice, mesh, mesh.points(), CGAL::parameters::default_values(), reading, elements,
                                  arrays, is_fixed)
            == GDP::ok);
  holds(mesh, faces, elements, arrays);
  std::size_t wrong = 0;
  for(std::size_t v = 0; v < elements.vertices.size(); ++v)
  {
    bool touches_outside = false;
    for(Face f : mesh.faces_around_target(mesh.halfedge(elements.vertices[v])))
      touches_outside |= f != Mesh::null_face() && !faces.count(f);
    wrong += (is_fixed[v] != 0) != touches_outside;
  }
  GDP_CHECK(wrong == 0);
}

int main()
{
  const Shape shapes[] = {jittered_square(40), ellipsoid(40, Vec(3, 1, 0.2)), sphere(3)};
  for(const Shape& shape : shapes)
  {
    const Shape disorder = shuffled(shape);
    GDP_CHECK(mean_span(disorder.triangles) > 0.3 * double(shape.points.size())); // what has to be mended
    for(bool parallel : {false, true})
    {
      test_whole(shape, parallel);
      test_whole(disorder, parallel);
    }
    test_region(disorder);
  }
  return GDP_TEST_RESULT();
}
