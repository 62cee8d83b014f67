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

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace GDP = CGAL::Gradient_domain_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Simple_cartesian<double>      Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
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

  // The right half; any range of faces will do.
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  std::vector<face_descriptor> region;
  for(face_descriptor f : faces(mesh))
    if(mesh.point(target(halfedge(f, mesh), mesh)).x() > (box.xmin() + box.xmax()) / 2)
      region.push_back(f);

  const GDP::Error_code code = GDP::smooth(region, mesh, GDP::parameters::gradient_weight(1e-3));
  if(code != GDP::OK)
  {
    std::cerr << GDP::get_error_message(code) << std::endl;
    return EXIT_FAILURE;
  }

  std::cout << "Smoothed " << region.size() << " of " << num_faces(mesh) << " faces: smoothed_region.off" << std::endl;
  CGAL::IO::write_polygon_mesh("smoothed_region.off", mesh, CGAL::parameters::stream_precision(17));
  return EXIT_SUCCESS;
}
