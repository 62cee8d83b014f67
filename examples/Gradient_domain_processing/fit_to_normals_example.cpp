// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Gradient_domain_processing/fit_to_normals.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace GDP = CGAL::Gradient_domain_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Simple_cartesian<double>      Kernel;
typedef Kernel::Vector_3                    Vector;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Vertex_index                  vertex_descriptor;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/pebble.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // A normal map with ripples, as a renderer would use it to fake them: the normals tilt to and fro along x.
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  auto normal = mesh.add_property_map<vertex_descriptor, Vector>("v:normal").first;
  PMP::compute_vertex_normals(mesh, normal);
  for(vertex_descriptor v : vertices(mesh))
  {
    const Vector tilted =
      normal[v] + Vector(0.5 * std::sin(40 * (mesh.point(v).x() - box.xmin()) / (box.xmax() - box.xmin())), 0, 0);
    normal[v] = tilted / std::sqrt(tilted.squared_length());
  }

  // With them, the ripples become geometry.
  const GDP::Error_code code = GDP::fit_to_normals(mesh, normal);
  if(code != GDP::OK)
  {
    std::cerr << GDP::get_error_message(code) << std::endl;
    return EXIT_FAILURE;
  }

  std::cout << "Fitted " << num_vertices(mesh) << " vertices to rippled normals: fitted_to_normals.off" << std::endl;
  CGAL::IO::write_polygon_mesh("fitted_to_normals.off", mesh, CGAL::parameters::stream_precision(17));
  return EXIT_SUCCESS;
}
