// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Gradient_domain_processing/fit_to_gradients.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace GDP = CGAL::Gradient_domain_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Simple_cartesian<double>      Kernel;
typedef Kernel::Vector_3                    Vector;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Halfedge_index                halfedge_descriptor;
typedef Mesh::Vertex_index                  vertex_descriptor;
typedef Mesh::Face_index                    face_descriptor;
typedef std::array<double, 3>               Rgb;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/pebble.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Two paintings of the mesh: one goes from blue to red, the other has spots on a dark ground.
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const double size = box.xmax() - box.xmin();
  auto painting = mesh.add_property_map<vertex_descriptor, Rgb>("v:painting").first;
  auto spots = mesh.add_property_map<vertex_descriptor, Rgb>("v:spots").first;
  const auto x = [&](vertex_descriptor v) { return (mesh.point(v).x() - box.xmin()) / size; };
  const auto y = [&](vertex_descriptor v) { return (mesh.point(v).y() - box.ymin()) / size; };
  for(vertex_descriptor v : vertices(mesh))
  {
    const double spot = 40 + 60 * std::sin(30 * x(v)) * std::sin(30 * y(v));
    painting[v] = {60 + 140 * x(v), 120, 200 - 140 * x(v)};
    spots[v] = {spot, spot, 40};
  }

  // The gradient of the spots on every face: the values, each times the opposite edge turned by a right angle.
  auto gradient = mesh.add_property_map<face_descriptor, std::array<Vector, 3> >("f:gradient").first;
  std::vector<face_descriptor> region;
  for(face_descriptor f : faces(mesh))
  {
    const halfedge_descriptor h = halfedge(f, mesh);
    const vertex_descriptor v[3] = {source(h, mesh), target(h, mesh), target(next(h, mesh), mesh)};
    const Vector normal = CGAL::cross_product(mesh.point(v[1]) - mesh.point(v[0]), mesh.point(v[2]) - mesh.point(v[0]));
    for(int channel = 0; channel < 3; ++channel)
    {
      Vector edges = CGAL::NULL_VECTOR;
      for(int i = 0; i < 3; ++i)
        edges += spots[v[i]][channel] * (mesh.point(v[(i + 2) % 3]) - mesh.point(v[(i + 1) % 3]));
      gradient[f][channel] = CGAL::cross_product(normal, edges) / normal.squared_length();
    }
    if(std::hypot(x(v[0]) - 0.5, y(v[0]) - 0.4) < 0.25)
      region.push_back(f);
  }
  // Inside the region, the gradients of the spots; around it, the painting.
  const GDP::Error_code code =
    GDP::fit_to_gradients(region, mesh, painting, gradient, painting, GDP::parameters::value_weight(0));
  if(code != GDP::OK)
  {
    std::cerr << GDP::get_error_message(code) << std::endl;
    return EXIT_FAILURE;
  }

  auto color = mesh.add_property_map<vertex_descriptor, CGAL::IO::Color>("v:color").first;
  for(vertex_descriptor v : vertices(mesh))
    color[v] = GDP::Signal_traits<CGAL::IO::Color>::make(
      std::array<double, 4>{painting[v][0], painting[v][1], painting[v][2], 255}.data());
  std::cout << "Cloned the spots into " << region.size() << " faces: cloned.ply" << std::endl;
  CGAL::IO::write_PLY("cloned.ply", mesh);
  return EXIT_SUCCESS;
}
