// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Gradient_domain_processing/stitch.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace GDP = CGAL::Gradient_domain_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Simple_cartesian<double>      Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Vertex_index                  vertex_descriptor;
typedef CGAL::IO::Color                     Color;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/pebble.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Two photographs of one pattern; the one of the right half is darker and more yellow.
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  auto photograph = mesh.add_property_map<vertex_descriptor, int>("v:photograph", 0).first;
  auto color = mesh.add_property_map<vertex_descriptor, Color>("v:color").first;
  for(vertex_descriptor v : vertices(mesh))
  {
    const double x = (mesh.point(v).x() - box.xmin()) / (box.xmax() - box.xmin()),
                 y = (mesh.point(v).y() - box.ymin()) / (box.xmax() - box.xmin());
    const int pattern = int(25 * std::sin(25 * x) * std::cos(25 * y));
    photograph[v] = x > 0.5;
    color[v] = photograph[v] == 0 ? Color(170 + pattern, 190 - pattern, 220 + pattern)
                                  : Color(140 + pattern, 140 - pattern, 110 + pattern);
  }
  CGAL::IO::write_PLY("two_photographs.ply", mesh);

  const GDP::Error_code code = GDP::stitch(mesh, photograph, color, color);
  if(code != GDP::OK)
  {
    std::cerr << GDP::get_error_message(code) << std::endl;
    return EXIT_FAILURE;
  }

  std::cout << "Stitched two_photographs.ply: one_photograph.ply" << std::endl;
  CGAL::IO::write_PLY("one_photograph.ply", mesh);
  return EXIT_SUCCESS;
}
