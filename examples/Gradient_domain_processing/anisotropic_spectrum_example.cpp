// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Gradient_domain_processing/curvature_metric.h>
#include <CGAL/Gradient_domain_processing/spectrum.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>

namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double>      Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

// Writes one harmonic as a property.
void add_property(const Eigen::MatrixXd& harmonics, int k, const std::string& name, Mesh& mesh)
{
  auto map = mesh.add_property_map<Mesh::Vertex_index, double>("v:" + name, 0).first;
  for(Mesh::Vertex_index v : mesh.vertices())
    map[v] = harmonics(int(v), k);
}

// The harmonics of the surface; of its edge-aware metric, in which creases are far away; and of a conductance that lets
// less pass along directions in which the surface is curved.
int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/pebble.off";
  const int which = 8;

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  Eigen::VectorXd eigenvalues;
  Eigen::MatrixXd harmonics;
  GDP::Error_code code = GDP::spectrum(mesh, which + 1, eigenvalues, harmonics);
  if(code == GDP::OK)
    add_property(harmonics, which, "embedding", mesh);

  auto metrics = mesh.add_property_map<Mesh::Face_index, GDP::Triangle_metric>("f:metric").first;
  if(code == GDP::OK)
    code = GDP::curvature_metric(mesh, metrics, GDP::parameters::curvature_weight(0.02));
  if(code == GDP::OK)
    code = GDP::spectrum(mesh, which + 1, eigenvalues, harmonics, GDP::parameters::face_metric_map(metrics));
  if(code == GDP::OK)
    add_property(harmonics, which, "edge_aware", mesh);

  // after Andreux et al. 2014, with a length as their alpha: a surface bent to this radius conducts half as well
  const double a = std::sqrt(CGAL::Polygon_mesh_processing::area(mesh)) / 10;
  const auto slowness = [a](double k1, double k2) {
    return std::make_pair(1 + a * std::abs(k1), 1 + a * std::abs(k2));
  };
  if(code == GDP::OK)
    code = GDP::curvature_metric(mesh, metrics, GDP::parameters::curvature_metric_kind(slowness));
  if(code == GDP::OK)
    code = GDP::spectrum(mesh, which + 1, eigenvalues, harmonics,
                         GDP::parameters::face_metric_map(metrics).embedding_measure(true));
  if(code == GDP::OK)
    add_property(harmonics, which, "anisotropic", mesh);

  if(code != GDP::OK)
  {
    std::cerr << GDP::get_error_message(code) << std::endl;
    return EXIT_FAILURE;
  }
  mesh.remove_property_map(metrics);
  return CGAL::IO::write_PLY("harmonics.ply", mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
