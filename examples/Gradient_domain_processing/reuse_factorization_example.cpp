// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Gradient_domain_processing/Gradient_domain_solver.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double>      Kernel;
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

  // Most of the time goes here, and once.
  GDP::Gradient_domain_solver<Mesh> solver(mesh, GDP::parameters::gradient_weight(1e-3));
  GDP::Error_code code = solver.factorize();

  // A slider: every position of it costs no more than a back-substitution.
  auto position = mesh.add_property_map<vertex_descriptor, Kernel::Point_3>("v:position").first;
  for(const double scale : {0., 0.5, 2., 3.})
  {
    if(code == GDP::OK)
      code = solver.set_gradient_scale(scale);
    if(code == GDP::OK)
      code = solver.filter(mesh.points(), position);
    if(code != GDP::OK)
    {
      std::cerr << GDP::get_error_message(code) << std::endl;
      return EXIT_FAILURE;
    }
    const std::string result = "scale_" + std::to_string(int(10 * scale)) + ".off";
    std::cout << "Scaled the gradients by " << scale << ": " << result << std::endl;
    CGAL::IO::write_polygon_mesh(result, mesh, CGAL::parameters::vertex_point_map(position).stream_precision(17));
  }
  return EXIT_SUCCESS;
}
