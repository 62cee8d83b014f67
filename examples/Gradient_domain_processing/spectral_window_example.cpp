// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <CGAL/Gradient_domain_processing/filter_spectrum.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace GDP = CGAL::Gradient_domain_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Simple_cartesian<double>      Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

// Three ways to keep waves longer than a tenth of the extent: Butterworth's filter, a windowed step, and a function of
// one's own, here the heat kernel.
int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/pebble.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const double wavelength = std::hypot(box.x_span(), box.y_span(), box.z_span()) / 10;
  const double time = std::log(2.) / GDP::Spectral_filter::eigenvalue(wavelength);
  const auto heat_kernel = [time](double mu) { return std::exp(-time * mu); };

  for(const GDP::Spectral_filter& filter :
      {GDP::Spectral_filter::low_pass(wavelength),
       GDP::Spectral_filter::windowed_low_pass(wavelength, 40, GDP::Spectral_window::HAMMING),
       GDP::Spectral_filter::approximation(heat_kernel, wavelength, 1e-6)})
  {
    Mesh result = mesh;
    const GDP::Error_code code = GDP::filter_spectrum(mesh, mesh.points(), result.points(), filter);
    if(code != GDP::OK)
    {
      std::cerr << GDP::get_error_message(code) << std::endl;
      return EXIT_FAILURE;
    }
    double moved = 0;
    for(Mesh::Vertex_index v : mesh.vertices())
      moved = (std::max)(moved, CGAL::squared_distance(mesh.point(v), result.point(v)));
    std::cout << "degree " << filter.degree() << ", error at most " << filter.error_bound() << ": moved up to "
              << std::sqrt(moved) << std::endl;
  }
  return EXIT_SUCCESS;
}
