// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Gradient_domain_processing/estimate_curvatures.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double>                    Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>               Mesh;
typedef Mesh::Vertex_index                                vertex_descriptor;
typedef GDP::Principal_curvatures_and_directions<Kernel>  Curvature;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/pebble.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Any class with these four members will do, for example what PMP::interpolated_corrected_curvatures() of CGAL 6
  // finds.
  auto curvature = mesh.add_property_map<vertex_descriptor, Curvature>("v:curvature").first;
  GDP::Error_code code = GDP::estimate_curvatures(mesh, curvature, GDP::parameters::presmoothing_weight(3e-4));

  // Edges are the tenth of the vertices that is most curved; they are to be kept as they are, and all else shall count
  // as flat.
  const auto strength = [](const Curvature& k) {
    return (std::max)(std::abs(k.min_curvature), std::abs(k.max_curvature));
  };
  std::vector<double> strengths;
  for(const Curvature& k : curvature)
    strengths.push_back(strength(k));
  const auto threshold = strengths.begin() + strengths.size() * 9 / 10;
  std::nth_element(strengths.begin(), threshold, strengths.end());
  for(Curvature& k : curvature)
    if(strength(k) < *threshold)
      k.min_curvature = k.max_curvature = 0;

  if(code == GDP::OK)
    code =
      GDP::smooth(mesh, GDP::parameters::vertex_curvature_map(curvature).curvature_weight(1.).gradient_weight(1e-3));
  if(code != GDP::OK)
  {
    std::cerr << GDP::get_error_message(code) << std::endl;
    return EXIT_FAILURE;
  }

  std::cout << "Smoothed all but what is curved more than " << *threshold << ": own_curvature.off" << std::endl;
  CGAL::IO::write_polygon_mesh("own_curvature.off", mesh, CGAL::parameters::stream_precision(17));
  return EXIT_SUCCESS;
}
