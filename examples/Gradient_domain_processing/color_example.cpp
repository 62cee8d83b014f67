// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Gradient_domain_processing/process_signal.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Random.h>

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

  // A mesh without colors gets noisy stripes.
  auto [color, is_new] = mesh.add_property_map<vertex_descriptor, Color>("v:color");
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  CGAL::Random random(0);
  if(is_new)
    for(vertex_descriptor v : vertices(mesh))
    {
      const int stripe = std::sin(24 * (mesh.point(v).x() - box.xmin()) / (box.xmax() - box.xmin())) > 0 ? 160 : 60;
      const int noise = random.get_int(-40, 40);
      color[v] = Color(stripe + noise, 110 + noise, 220 - stripe + noise);
    }
  CGAL::IO::write_PLY("colors.ply", mesh);

  // Smoothed, and then sharpened: the mesh stays as it is.
  GDP::Error_code code = GDP::process_signal(mesh, color, color, GDP::parameters::gradient_weight(3e-4));
  CGAL::IO::write_PLY("smoothed_colors.ply", mesh);
  if(code == GDP::OK)
    code = GDP::process_signal(mesh, color, color, GDP::parameters::gradient_weight(1e-3).gradient_scale(3));
  if(code != GDP::OK)
  {
    std::cerr << GDP::get_error_message(code) << std::endl;
    return EXIT_FAILURE;
  }
  CGAL::IO::write_PLY("sharpened_colors.ply", mesh);

  std::cout << "Filtered the colors of " << num_vertices(mesh) << " vertices:"
            << " colors.ply, smoothed_colors.ply, sharpened_colors.ply" << std::endl;
  return EXIT_SUCCESS;
}
