// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Gradient_domain_processing/fit_to_gradients.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/property_map.h>

#include <array>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace GDP = CGAL::Gradient_domain_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3                Point;
typedef Kernel::Vector_3               Vector;
typedef CGAL::Surface_mesh<Point>      Mesh;
typedef Mesh::Vertex_index             vertex_descriptor;
typedef Mesh::Face_index               face_descriptor;
typedef std::array<Vector, 3>          Gradients;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/pebble.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Two surfaces: the mesh is cut in two, and the upper part is made larger, turned and lifted.
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const Point center =
    CGAL::midpoint(Point(box.xmin(), box.ymin(), box.zmin()), Point(box.xmax(), box.ymax(), box.zmax()));
  auto part = mesh.add_property_map<face_descriptor, int>("f:part", 0).first;
  for(face_descriptor f : faces(mesh))
    part[f] = mesh.point(target(halfedge(f, mesh), mesh)).y() > center.y();
  Mesh lower, upper;
  std::vector<std::pair<vertex_descriptor, vertex_descriptor> > copies;
  CGAL::copy_face_graph(CGAL::Face_filtered_graph<Mesh>(mesh, 0, part), lower);
  CGAL::copy_face_graph(CGAL::Face_filtered_graph<Mesh>(mesh, 1, part), upper,
                        CGAL::parameters::vertex_to_vertex_output_iterator(std::back_inserter(copies)));
  for(vertex_descriptor v : vertices(upper))
  {
    const Vector p = upper.point(v) - center;
    upper.point(v) =
      center
      + Vector(1.1 * p.x() + 0.5 * p.z(), 1.2 * p.y() + 0.1 * (box.ymax() - box.ymin()), 1.1 * p.z() - 0.5 * p.x());
  }
  Mesh before = lower;
  CGAL::copy_face_graph(upper, before);
  CGAL::IO::write_polygon_mesh("two_surfaces.off", before, CGAL::parameters::stream_precision(17));

  // The border of the upper surface goes to that of the lower; inside, the gradients of positions, the axes, stay.
  auto position = upper.add_property_map<vertex_descriptor, Point>("v:position").first;
  auto is_constrained = upper.add_property_map<vertex_descriptor, bool>("v:is_constrained", false).first;
  for(const auto& [original, v] : copies)
  {
    is_constrained[v] = CGAL::is_border(v, upper).has_value();
    position[v] = is_constrained[v] ? mesh.point(original) : upper.point(v);
  }
  const CGAL::Constant_property_map<face_descriptor, Gradients> axes(
    Gradients{Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)});
  const GDP::Error_code code = GDP::fit_to_gradients(upper, position, axes, upper.points(),
    GDP::parameters::value_weight(0).vertex_is_constrained_map(is_constrained));
  if(code != GDP::OK)
  {
    std::cerr << GDP::get_error_message(code) << std::endl;
    return EXIT_FAILURE;
  }

  CGAL::copy_face_graph(upper, lower);
  PMP::stitch_borders(lower);
  const bool is_closed = CGAL::is_closed(lower);
  std::cout << "Merged two surfaces into one that is " << (is_closed ? "" : "not ") << "closed: merged.off"
            << std::endl;
  CGAL::IO::write_polygon_mesh("merged.off", lower, CGAL::parameters::stream_precision(17));
  return is_closed == CGAL::is_closed(mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
