// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Gradient_domain_processing/process_signal.h>

#include <CGAL/Eigen_solver_traits.h>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace GDP = CGAL::Gradient_domain_processing;

typedef CGAL::Simple_cartesian<double>      Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Vertex_index                  vertex_descriptor;

// A solver of our own, a model of SparseLinearAlgebraWithFactorTraits_d: conjugate gradients.
struct Conjugate_gradients
{
  typedef double                            NT;
  typedef CGAL::Eigen_sparse_matrix<double> Matrix;
  typedef CGAL::Eigen_vector<double>        Vector;

  bool factor(const Matrix& A, NT& D)
  {
    D = 1;
    m_matrix = &A.eigen_object(); // is there as long as the solver is used
    return true;
  }

  bool linear_solver(const Vector& B, Vector& X)
  {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(B.size()), residual = B, direction = B;
    double squared = residual.squaredNorm();
    const double enough = 1e-24 * squared;
    for(int i = 0; i < 10000 && squared > enough; ++i)
    {
      const Eigen::VectorXd image = *m_matrix * direction;
      const double step = squared / direction.dot(image), last = squared;
      x += step * direction;
      residual -= step * image;
      squared = residual.squaredNorm();
      direction = residual + squared / last * direction;
    }
    X = x;
    return squared <= enough;
  }

  bool linear_solver(const Matrix& A, const Vector& B, Vector& X, NT& D) { return factor(A, D) && linear_solver(B, X); }

private:
  const Matrix::EigenType* m_matrix = nullptr;
};

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/pebble.off";

  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "Cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // One of Eigen's solvers, and ours.
  typedef CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double> > > Eigen_solver;
  auto by_eigen = mesh.add_property_map<vertex_descriptor, Kernel::Point_3>("v:by_eigen").first;
  auto by_us = mesh.add_property_map<vertex_descriptor, Kernel::Point_3>("v:by_us").first;
  GDP::Error_code code =
    GDP::process_signal(mesh, mesh.points(), by_eigen, GDP::parameters::sparse_linear_solver(Eigen_solver()));
  if(code == GDP::OK)
    code =
      GDP::process_signal(mesh, mesh.points(), by_us, GDP::parameters::sparse_linear_solver(Conjugate_gradients()));
  if(code != GDP::OK)
  {
    std::cerr << GDP::get_error_message(code) << std::endl;
    return EXIT_FAILURE;
  }

  double difference = 0;
  for(vertex_descriptor v : vertices(mesh))
    difference = (std::max)(difference, std::sqrt(CGAL::squared_distance(by_eigen[v], by_us[v])));
  std::cout << "The results of the two solvers differ by " << difference << " at most" << std::endl;
  return EXIT_SUCCESS;
}
