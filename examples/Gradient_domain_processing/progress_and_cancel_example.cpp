// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Gradient_domain_processing/smooth.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double>      Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

// Says what is being done, and cancels when asked to; another thread might ask.
struct Progress_visitor : GDP::Default_visitor
{
  bool is_cancelled = false;

  void stage_begins(GDP::Stage stage) { std::cout << " " << GDP::get_stage_name(stage) << std::flush; }
  bool go_on(double) { return !is_cancelled; }
};

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/pebble.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  Progress_visitor visitor;
  const auto np = GDP::parameters::curvature_weight(0.02).visitor(std::ref(visitor)); // by reference, as it has a state
  GDP::Error_code code = GDP::smooth(mesh, np);
  std::cout << ": " << GDP::get_error_message(code) << std::endl;
  if(code != GDP::OK)
    return EXIT_FAILURE;

  visitor.is_cancelled = true;
  code = GDP::smooth(mesh, np); // leaves the mesh as it was
  std::cout << ": " << GDP::get_error_message(code) << std::endl;
  return code == GDP::ERROR_CANCELLED ? EXIT_SUCCESS : EXIT_FAILURE;
}
