// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// spectrum() on meshes.

#include "test_shapes.h"
#include "test_utils.h"

#include <iostream>
#include <CGAL/Gradient_domain_processing/spectrum.h>

using namespace gdp_test;
namespace GDP = CGAL::Gradient_domain_processing;

int main()
{
  Mesh mesh = mesh_of(sphere(8).scaled(10));
  mesh.add_vertex(Point(1, 2, 3));
  Eigen::VectorXd values;
  Eigen::MatrixXd harmonics;
  GDP_CHECK(GDP::spectrum(mesh, 9, values, harmonics) == GDP::ok);
  GDP_CHECK(values.size() == 9 && harmonics.cols() == 9 && harmonics.rows() == int(mesh.number_of_vertices()));
  for(int j = 0; j < 9; ++j)
    GDP_CHECK_NEAR(100 * values[j], j == 0 ? 0 : j < 4 ? 2 : 6, j < 4 ? 0.08 : 0.5);
  GDP_CHECK(harmonics.row(harmonics.rows() - 1).isZero(0));
  GDP_CHECK_NEAR(std::abs(harmonics(0, 0)), 1 / std::sqrt(total_area(mesh)), 1e-9);

  // a constrained vertex takes the constant's place
  auto is_constrained = mesh.add_property_map<Vertex, bool>("v:constrained", false).first;
  is_constrained[Vertex(5)] = true;
  GDP_CHECK(GDP::spectrum(mesh, 3, values, harmonics, GDP::parameters::vertex_is_constrained_map(is_constrained)) == GDP::ok);
  GDP_CHECK(values[0] > 1e-4 && harmonics.row(5).isZero(0));

  const Eigen::VectorXd before = values;
  GDP_CHECK(GDP::spectrum(mesh, -1, values, harmonics) == GDP::error_invalid_parameter);
  GDP_CHECK(GDP::spectrum(mesh, 100000, values, harmonics) == GDP::error_invalid_parameter);
  GDP_CHECK(GDP::spectrum(Mesh(), 1, values, harmonics) == GDP::error_empty_mesh && values == before);
  return GDP_TEST_RESULT();
}
