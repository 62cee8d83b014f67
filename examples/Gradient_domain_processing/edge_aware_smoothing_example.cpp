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
#include <iostream>
#include <string>

namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double>      Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/pebble.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Where the surface is curved, the metric makes it larger than it is, and it is smoothed less. Curvature is that of
  // the surface smoothed a little, so that noise does not count.
  const GDP::Error_code code = GDP::smooth(mesh,
    GDP::parameters::gradient_weight(1e-3)
                    .curvature_metric_kind(GDP::Curvature_metric_kind::EDGE_AWARE)
                    .curvature_weight(0.1)
                    .presmoothing_weight(3e-4));
  if(code != GDP::OK)
  {
    std::cerr << GDP::get_error_message(code) << std::endl;
    return EXIT_FAILURE;
  }

  std::cout << "Smoothed " << num_vertices(mesh) << " vertices and kept the edges: edge_aware.off" << std::endl;
  CGAL::IO::write_polygon_mesh("edge_aware.off", mesh, CGAL::parameters::stream_precision(17));
  return EXIT_SUCCESS;
}
