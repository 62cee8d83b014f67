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

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace GDP = CGAL::Gradient_domain_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Simple_cartesian<double>      Kernel;
typedef Kernel::Vector_3                    Vector;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Halfedge_index                halfedge_descriptor;
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

  // As on a lathe, only differences around the vertical axis are smoothed: squared lengths count a hundred times, but
  // around it.
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const Kernel::Point_3 center = CGAL::midpoint(Kernel::Point_3(box.xmin(), box.ymin(), box.zmin()),
                                                Kernel::Point_3(box.xmax(), box.ymax(), box.zmax()));
  auto metric = mesh.add_property_map<face_descriptor, GDP::Triangle_metric>("f:metric").first;
  for(face_descriptor f : faces(mesh))
  {
    const halfedge_descriptor h = halfedge(f, mesh);
    const Kernel::Point_3& v0 = mesh.point(source(h, mesh));
    const Vector t1 = mesh.point(target(h, mesh)) - v0, t2 = mesh.point(target(next(h, mesh), mesh)) - v0;
    const Vector radius = v0 + (t1 + t2) / 3 - center;
    const Vector around = Vector(radius.z(), 0, -radius.x()) / std::hypot(radius.x(), radius.z());
    const auto product = [&](const Vector& a, const Vector& b) {
      return 100 * (a * b) - 99 * (a * around) * (b * around);
    };
    metric[f] = GDP::Triangle_metric(product(t1, t1), product(t1, t2), product(t2, t2));
  }

  const GDP::Error_code code = GDP::smooth(mesh, GDP::parameters::face_metric_map(metric).gradient_weight(1e-2));
  if(code != GDP::OK)
  {
    std::cerr << GDP::get_error_message(code) << std::endl;
    return EXIT_FAILURE;
  }

  std::cout << "Smoothed around the vertical axis: turned.off" << std::endl;
  CGAL::IO::write_polygon_mesh("turned.off", mesh, CGAL::parameters::stream_precision(17));
  return EXIT_SUCCESS;
}
