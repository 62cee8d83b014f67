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

  // One copy keeps its ridges while its valleys are filled, the other keeps its valleys while its ridges are worn down.
  Mesh ridges = mesh, valleys = mesh;
  const auto weights = GDP::parameters::gradient_weight(1e-3).curvature_weight(1.);
  GDP::Error_code code =
    GDP::smooth(ridges, weights.curvature_metric_kind(GDP::Curvature_metric_kind::PRESERVE_CONVEX));
  if(code == GDP::OK)
    code = GDP::smooth(valleys, weights.curvature_metric_kind(GDP::Curvature_metric_kind::PRESERVE_CONCAVE));
  if(code != GDP::OK)
  {
    std::cerr << GDP::get_error_message(code) << std::endl;
    return EXIT_FAILURE;
  }

  std::cout << "Kept what is convex: kept_convex.off; kept what is concave: kept_concave.off" << std::endl;
  CGAL::IO::write_polygon_mesh("kept_convex.off", ridges, CGAL::parameters::stream_precision(17));
  CGAL::IO::write_polygon_mesh("kept_concave.off", valleys, CGAL::parameters::stream_precision(17));
  return EXIT_SUCCESS;
}
