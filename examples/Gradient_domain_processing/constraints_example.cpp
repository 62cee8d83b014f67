// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Gradient_domain_processing/process_signal.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>

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

  // The bottom is held and the top is moved aside.
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const double height = box.ymax() - box.ymin();
  auto displacement = mesh.add_property_map<vertex_descriptor, Vector>("v:displacement", CGAL::NULL_VECTOR).first;
  auto is_constrained = mesh.add_property_map<vertex_descriptor, bool>("v:is_constrained", false).first;
  for(vertex_descriptor v : vertices(mesh))
  {
    const double y = (mesh.point(v).y() - box.ymin()) / height;
    is_constrained[v] = y < 0.2 || y > 0.8;
    if(y > 0.8)
      displacement[v] = Vector(0.4 * height, 0.2 * height, 0);
  }

  // Without value weight, constraints alone decide: between them, the displacement changes as little as it can.
  const GDP::Error_code code = GDP::process_signal(mesh, displacement, displacement,
    GDP::parameters::value_weight(0).vertex_is_constrained_map(is_constrained));
  if(code != GDP::OK)
  {
    std::cerr << GDP::get_error_message(code) << std::endl;
    return EXIT_FAILURE;
  }
  for(vertex_descriptor v : vertices(mesh))
    mesh.point(v) += displacement[v];

  std::cout << "Moved the top, held the bottom, and let the rest follow: deformed.off" << std::endl;
  CGAL::IO::write_polygon_mesh("deformed.off", mesh, CGAL::parameters::stream_precision(17));
  return EXIT_SUCCESS;
}
