// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Gradient_domain_processing/fair.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace GDP = CGAL::Gradient_domain_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

typedef CGAL::Simple_cartesian<double>      Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Vertex_index                  vertex_descriptor;
typedef Mesh::Face_index                    face_descriptor;
typedef Mesh::Halfedge_index                halfedge_descriptor;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/pebble.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || mesh.is_empty())
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // A hole: where the surface is highest, its faces are taken away.
  double low = HUGE_VAL, high = -HUGE_VAL;
  for(vertex_descriptor v : vertices(mesh))
  {
    low = (std::min)(low, mesh.point(v).z());
    high = (std::max)(high, mesh.point(v).z());
  }
  for(face_descriptor f : faces(mesh))
  {
    bool is_high = true;
    for(vertex_descriptor v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      is_high = is_high && mesh.point(v).z() > high - 0.08 * (high - low);
    if(is_high)
      CGAL::Euler::remove_face(halfedge(f, mesh), mesh);
  }

  for(halfedge_descriptor h : std::vector<halfedge_descriptor>(halfedges(mesh).begin(), halfedges(mesh).end()))
    if(is_border(h, mesh))
    {
      std::vector<face_descriptor> patch_faces;
      std::vector<vertex_descriptor> patch_vertices;
      PMP::triangulate_and_refine_hole(mesh, h, std::back_inserter(patch_faces), std::back_inserter(patch_vertices));
      const GDP::Error_code code = GDP::fair(patch_vertices, mesh);
      if(code != GDP::OK)
      {
        std::cerr << GDP::get_error_message(code) << std::endl;
        return EXIT_FAILURE;
      }
      double top = -HUGE_VAL;
      for(vertex_descriptor v : patch_vertices)
        top = (std::max)(top, mesh.point(v).z());
      std::cout << "A patch of " << patch_vertices.size() << " vertices reaches up to " << top
                << ", the surface had reached " << high << std::endl;
    }

  CGAL::IO::write_polygon_mesh("fair.off", mesh, CGAL::parameters::stream_precision(17));
  return EXIT_SUCCESS;
}
