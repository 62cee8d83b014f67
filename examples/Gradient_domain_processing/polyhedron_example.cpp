// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Gradient_domain_processing/sharpen.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Polyhedron_3<Kernel>                          Polyhedron;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/pebble.off";

  Polyhedron polyhedron;
  if(!CGAL::IO::read_polygon_mesh(filename, polyhedron))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  GDP::Error_code code = GDP::smooth(polyhedron, GDP::parameters::gradient_weight(3e-4));
  if(code == GDP::OK)
    code = GDP::sharpen(polyhedron, GDP::parameters::gradient_weight(1e-3));
  if(code != GDP::OK)
  {
    std::cerr << GDP::get_error_message(code) << std::endl;
    return EXIT_FAILURE;
  }

  std::cout << "Smoothed and sharpened a polyhedron of " << num_vertices(polyhedron) << " vertices: polyhedron.off"
            << std::endl;
  CGAL::IO::write_polygon_mesh("polyhedron.off", polyhedron, CGAL::parameters::stream_precision(17));
  return EXIT_SUCCESS;
}
