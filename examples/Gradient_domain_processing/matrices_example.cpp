// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Gradient_domain_processing/operators.h>

#include <Eigen/SparseCholesky>

#include <cstdlib>
#include <iostream>
#include <string>

namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double>      Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Vertex_index                  vertex_descriptor;
typedef Eigen::SparseMatrix<double>         Matrix;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/pebble.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // A vertex without a face has no area, and its rows would be zero.
  for(vertex_descriptor v : vertices(mesh))
    if(mesh.is_isolated(v))
      mesh.remove_vertex(v);
  mesh.collect_garbage();

  Matrix mass, stiffness;
  GDP::Error_code code = GDP::mass_matrix(mesh, mass);
  if(code == GDP::OK)
    code = GDP::stiffness_matrix(mesh, stiffness);
  if(code != GDP::OK)
  {
    std::cerr << GDP::get_error_message(code) << std::endl;
    return EXIT_FAILURE;
  }

  // An energy of our own: |f - g|^2 + w |laplacian g|^2, which bends less and shrinks less than one of gradients.
  const Eigen::VectorXd areas = mass * Eigen::VectorXd::Ones(mass.cols());
  const double weight = 1e-7 * areas.sum() * areas.sum();
  const Matrix bending = stiffness * areas.cwiseInverse().asDiagonal() * stiffness;
  Eigen::SimplicialLDLT<Matrix> solver(mass + weight * bending);
  if(solver.info() != Eigen::Success)
  {
    std::cerr << "Cannot factorize the matrix" << std::endl;
    return EXIT_FAILURE;
  }

  Eigen::MatrixXd f(num_vertices(mesh), 3);
  for(vertex_descriptor v : vertices(mesh))
    f.row(v.idx()) << mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z();
  const Eigen::MatrixXd g = solver.solve(mass * f);
  for(vertex_descriptor v : vertices(mesh))
    mesh.point(v) = Kernel::Point_3(g(v.idx(), 0), g(v.idx(), 1), g(v.idx(), 2));

  std::cout << "Smoothed a surface of area " << areas.sum() << " by its Laplacian: bending.off" << std::endl;
  CGAL::IO::write_polygon_mesh("bending.off", mesh, CGAL::parameters::stream_precision(17));
  return EXIT_SUCCESS;
}
