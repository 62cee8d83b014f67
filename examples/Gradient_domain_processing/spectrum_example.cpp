// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Gradient_domain_processing/spectrum.h>

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

  Eigen::VectorXd eigenvalues;
  Eigen::MatrixXd harmonics;
  const GDP::Error_code code = GDP::spectrum(mesh, 10, eigenvalues, harmonics);
  if(code != GDP::OK)
  {
    std::cerr << GDP::get_error_message(code) << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "index,eigenvalue\n";
  for(int i = 0; i < eigenvalues.size(); ++i)
    std::cout << i << "," << eigenvalues[i] << "\n";
  return EXIT_SUCCESS;
}
