// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Gradient_domain_processing/denoise.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main(int argc, char* argv[])
{
  const std::string input = argc > 1 ? argv[1] : "data/pebble.off";
  const std::string output = argc > 2 ? argv[2] : "denoised.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(input, mesh))
  {
    std::cerr << "Cannot read " << input << std::endl;
    return EXIT_FAILURE;
  }

  // How strong the noise is, and how many passes it takes, is found from the mesh.
  GDP::Denoising_summary summary;
  const GDP::Error_code code = GDP::denoise(mesh, GDP::parameters::denoising_summary(std::ref(summary)));
  if(code != GDP::OK)
  {
    std::cerr << GDP::get_error_message(code) << std::endl;
    return EXIT_FAILURE;
  }
  CGAL::IO::write_polygon_mesh(output, mesh, CGAL::parameters::stream_precision(17));
  std::cout << input << ": noise level " << summary.noise_level << " radians, " << summary.number_of_outliers
            << " outliers, " << summary.number_of_iterations
            << " passes: " << GDP::get_denoising_end_message(summary.end) << ". See " << output << std::endl;
  return EXIT_SUCCESS;
}
