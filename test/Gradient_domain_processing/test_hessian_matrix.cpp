// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// hessian_matrix() and the matrices of deformation energies on meshes.

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/deformation_matrices.h>
#include <CGAL/Gradient_domain_processing/hessian_matrix.h>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;

namespace {

typedef Eigen::SparseMatrix<double> Sparse;

// Units are those of the mesh, numbers those of its vertices, with holes among them.
void test_units_and_numbers()
{
  for(double scale : {1., 7., 1e30})
  {
    Mesh mesh = mesh_of(sphere(8).scaled(scale));
    mesh.remove_vertex(mesh.add_vertex(Point(0, 0, 0)));
    mesh.add_vertex(Point(scale, scale, scale));
    Eigen::VectorXd z = Eigen::VectorXd::Zero(mesh.num_vertices());
    for(Vertex v : mesh.vertices())
      z[int(v)] = mesh.point(v).z();
    const double area = total_area(mesh);
    const double expected[4] = {2, 4, 0, 4}; // of int z^2 = radius^2 area / 3, over radius^4
    const GDP::Hessian_kind kinds[4] = {GDP::Hessian_kind::SQUARED_HESSIAN, GDP::Hessian_kind::CURVED_HESSIAN,
                                        GDP::Hessian_kind::TRACE_FREE_HESSIAN, GDP::Hessian_kind::BILAPLACIAN};
    for(int i = 0; i < 4; ++i)
    {
      Sparse hessian;
      GDP_CHECK(GDP::hessian_matrix(mesh, kinds[i], hessian) == GDP::ok);
      GDP_CHECK(hessian.rows() == z.size() || hessian.rows() == int(mesh.number_of_vertices()));
      GDP_CHECK_NEAR(z.head(hessian.rows()).dot(hessian * z.head(hessian.rows())) * scale * scale / (area / 3),
                     expected[i], 0.6);
    }

    Sparse dirichlet, shell;
    GDP_CHECK(GDP::modified_dirichlet_matrix(mesh, dirichlet) == GDP::ok);
    GDP_CHECK_NEAR(Eigen::VectorXd::Ones(dirichlet.rows()).dot(dirichlet * Eigen::VectorXd::Ones(dirichlet.rows()))
                     / (8 * pi),
                   1, 0.07);
    GDP_CHECK(GDP::shell_hessian_matrix(mesh, scale * scale, scale, 1, shell) == GDP::ok);
    Sparse of_unit;
    GDP_CHECK(GDP::shell_hessian_matrix(mesh_of(sphere(8)), 1, 1, 1, of_unit) == GDP::ok);
    GDP_CHECK_NEAR(Eigen::MatrixXd(shell.topLeftCorner(of_unit.rows(), of_unit.rows()) - of_unit).cwiseAbs().maxCoeff()
                     / of_unit.norm(),
                   0, 1e-12);
    GDP_CHECK(GDP::shell_hessian_matrix(mesh, -1, 1, 1, shell) == GDP::error_invalid_weight);
  }
}

} // namespace

int main()
{
  test_units_and_numbers();
  return GDP_TEST_RESULT();
}
