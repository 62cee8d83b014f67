// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Gradient_domain_processing/smooth.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace GDP = CGAL::Gradient_domain_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Simple_cartesian<double>      Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Vertex_index                  vertex_descriptor;
typedef Mesh::Face_index                    face_descriptor;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/pebble.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // From -1 at the left to 1 at the right, and from 0 at the bottom to 1 at the top.
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const auto x = [&](vertex_descriptor v) {
    return 2 * (mesh.point(v).x() - box.xmin()) / (box.xmax() - box.xmin()) - 1;
  };
  const auto y = [&](vertex_descriptor v) { return (mesh.point(v).y() - box.ymin()) / (box.ymax() - box.ymin()); };
  const auto corner = [&](face_descriptor f) { return target(halfedge(f, mesh), mesh); };

  // Smoothed at the left, sharpened at the right (a scale of 1 in between changes nothing); large details at the left,
  // small ones at the right; and the closer to the top, the less of it all.
  const auto scale = boost::make_function_property_map<face_descriptor>(
    [&](face_descriptor f) { return 1 + x(corner(f)); });
  const auto weight = boost::make_function_property_map<face_descriptor>(
    [&](face_descriptor f) { return 1e-3 * std::pow(3., -x(corner(f))); });
  const auto value_weight = boost::make_function_property_map<vertex_descriptor>(
    [&](vertex_descriptor v) { return std::pow(100., y(v)); });

  const GDP::Error_code code = GDP::smooth(mesh, GDP::parameters::face_gradient_scale_map(scale)
                                                                 .face_gradient_weight_map(weight)
                                                                 .vertex_value_weight_map(value_weight));
  if(code != GDP::OK)
  {
    std::cerr << GDP::get_error_message(code) << std::endl;
    return EXIT_FAILURE;
  }

  std::cout << "Smoothed the left and sharpened the right, in one go: masked.off" << std::endl;
  CGAL::IO::write_polygon_mesh("masked.off", mesh, CGAL::parameters::stream_precision(17));
  return EXIT_SUCCESS;
}
