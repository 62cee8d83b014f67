// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The modified Dirichlet energy, and the Hessian of a discrete shell at rest.

#include "test_arrays.h"

#include <CGAL/Gradient_domain_processing/internal/higher_order/bilaplacian.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/modified_dirichlet.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/shell_hessian.h>

#include <vector>

using namespace gdp_test;
using namespace GDP::internal;

namespace {

Sparse stiffness_matrix(const Arrays& arrays)
{
  const std::vector<Vec3> same(arrays.points.size(), Vec3(0, 0, 1));
  return modified_dirichlet(arrays, Metrics(), same, true);
}

Sparse modified_dirichlet_of(const Arrays& arrays)
{
  return modified_dirichlet(arrays, Metrics(), arrays.vertex_normals(true), true);
}

// |grad u|^2 + (k1^2 + k2^2) u^2 on a unit sphere is 8 pi for u = 1 and 4 for a harmonic of degree one with norm one.
void test_modified_dirichlet_of_a_sphere()
{
  double last[2] = {0, 0};
  for(int level = 3; level <= 4; ++level)
  {
    const Arrays sphere = arrays_of(icosphere(level));
    const Eigen::VectorXd z = sampled(sphere, [](const Vec&p) { return p.z(); }), one = Eigen::VectorXd::Ones(z.size());
    const std::vector<double> masses = lumped_masses(sphere, Metrics(), true);
    const double norm = z.cwiseAbs2().dot(Eigen::Map<const Eigen::VectorXd>(masses.data(), z.size()));
    const double four_pi = 16 * std::atan(1.);

    const Sparse of_mesh = modified_dirichlet_of(sphere),
                 of_sphere = modified_dirichlet(sphere, Metrics(), sphere.points, true);
    GDP_CHECK_NEAR(energy(of_mesh, one) / 2, four_pi, 0.002 * four_pi);
    GDP_CHECK_NEAR(energy(of_mesh, z) / norm, 4, 0.015);
    const double error[2] = {energy(of_sphere, one) / 2 / four_pi - 1, energy(of_sphere, z) / norm / 4 - 1};
    for(int i = 0; i < 2; ++i)
    {
      GDP_CHECK_NEAR(error[i], 0, level == 3 ? 0.01 : 0.0025);
      GDP_CHECK(level == 3 || std::abs(error[i] / last[i] - 0.25) < 0.01);
      last[i] = error[i];
    }
  }
}

void test_modified_dirichlet()
{
  const Arrays plane = arrays_of(grid(5, 4)), patch = arrays_of(bumpy_patch(6, 5));
  GDP_CHECK(largest(Sparse(modified_dirichlet_of(plane) - stiffness_matrix(plane))) < 1e-15);

  // the Dirichlet energy of the three coordinates of u N
  const Eigen::VectorXd u = sampled(patch, [](const Vec& p) { return std::sin(7 * p.x()) + p.y(); });
  const std::vector<Vec3> normals = patch.vertex_normals(true);
  double sum = 0;
  for(int k = 0; k < 3; ++k)
  {
    Eigen::VectorXd coordinate = u;
    for(int v = 0; v < int(u.size()); ++v)
      coordinate[v] *= normals[v][k];
    sum += energy(stiffness_matrix(patch), coordinate);
  }
  GDP_CHECK_NEAR(energy(modified_dirichlet_of(patch), u) / sum, 1, 1e-13);
}

double dihedral_angle(const std::array<Vec, 4>& p)
{
  const Vec n1 = (p[0] - p[2]).cross(p[1] - p[2]), n2 = (p[1] - p[3]).cross(p[0] - p[3]);
  return -std::atan2((p[1] - p[0]).normalized().dot(n1.cross(n2)), n1.dot(n2));
}

void test_gradients()
{
  Random random(23);
  const double step = 1e-6;
  for(int trial = 0; trial < 20; ++trial)
  {
    std::array<Vec, 4> p = {{Vec(0, 0, 0), Vec(1, 0, 0), Vec(0.5, -1, 0), Vec(0.4, 1, 0)}};
    for(Vec& q : p)
      for(int k = 0; k < 3; ++k)
        q[k] += random(-0.4, 0.4);
    const auto dihedral = dihedral_gradient(p[0], p[1], p[2], p[3]);
    const auto area = area_gradient(p[0], p[1], p[2]);
    for(int i = 0; i < 4; ++i)
      for(int k = 0; k < 3; ++k)
      {
        std::array<Vec, 4> more = p, less = p;
        more[i][k] += step;
        less[i][k] -= step;
        GDP_CHECK_NEAR((dihedral_angle(more) - dihedral_angle(less)) / (2 * step), dihedral[i][k], 1e-7);
        if(i < 3)
        {
          const auto half_cross = [](const std::array<Vec, 4>& q) {
            return (q[1] - q[0]).cross(q[2] - q[0]).norm() / 2;
          };
          GDP_CHECK_NEAR((half_cross(more) - half_cross(less)) / (2 * step), area[i][k], 1e-8);
        }
      }
  }
}

// The energy of which the matrix is the Hessian, term by term.
double shell_energy(const Soup& rest, const Soup& moved, const Shell_stiffness& stiffness)
{
  const Arrays a = arrays_of(rest), b = arrays_of(moved);
  const auto area = [](const Arrays& arrays, const std::array<int, 3>& t) {
    return (arrays.points[t[1]] - arrays.points[t[0]]).cross(arrays.points[t[2]] - arrays.points[t[0]]).norm() / 2;
  };
  std::map<std::pair<int, int>, std::vector<int> > edges; // the corners opposite to them
  double sum = 0;
  for(int f = 0; f < a.number_of_triangles(); ++f)
  {
    const auto& t = a.triangles[f];
    sum += stiffness.area / area(a, t) * std::pow(area(b, t) - area(a, t), 2);
    for(int i = 0; i < 3; ++i)
    {
      const int j = t[(i + 1) % 3], k = t[(i + 2) % 3];
      edges[{(std::min)(j, k), (std::max)(j, k)}].push_back(3 * f + i);
    }
  }
  for(const auto& edge : edges)
  {
    const int i = edge.first.first, j = edge.first.second;
    const double length = (a.points[i] - a.points[j]).norm();
    sum += stiffness.length / length * std::pow((b.points[i] - b.points[j]).norm() - length, 2);
    if(edge.second.size() != 2)
      continue;
    const int c = edge.second[0], d = edge.second[1];
    const int k = a.triangles[c / 3][c % 3], l = a.triangles[d / 3][d % 3];
    const double angle = dihedral_angle({{b.points[i], b.points[j], b.points[k], b.points[l]}})
                       - dihedral_angle({{a.points[i], a.points[j], a.points[k], a.points[l]}});
    sum += 3 * stiffness.bending * length * length / (area(a, a.triangles[c / 3]) + area(a, a.triangles[d / 3])) * angle
           * angle;
  }
  return sum / 2;
}

void test_shell_hessian()
{
  const Soup rest = bumpy_patch(5, 4);
  const int n = int(rest.points.size());
  Random random(29);
  Eigen::VectorXd direction(3 * n);
  for(double& x : direction)
    x = random(-1, 1);
  const double step = 1e-5;
  for(const Shell_stiffness& stiffness :
      {Shell_stiffness{1, 0, 0}, Shell_stiffness{0, 1, 0}, Shell_stiffness{0, 0, 1}, Shell_stiffness{2, 3, 4}})
  {
    const Sparse hessian = shell_hessian(arrays_of(rest), stiffness, true);
    double sum = 0;
    for(double sign : {-1., 1.})
    {
      Soup moved = rest;
      for(int i = 0; i < 3 * n; ++i)
        moved.points[i / 3][i % 3] += sign * step * direction[i];
      sum += shell_energy(rest, moved, stiffness);
    }
    GDP_CHECK_NEAR(sum / (step * step) / energy(hessian, direction), 1, 1e-5);
  }
}

// Displacements by three translations and three rotations.
Eigen::MatrixXd rigid_motions(const Arrays& arrays)
{
  Eigen::MatrixXd motions(3 * arrays.number_of_vertices(), 6);
  for(int v = 0; v < arrays.number_of_vertices(); ++v)
    for(int k = 0; k < 3; ++k)
    {
      motions.block<3, 1>(3 * v, k) = Vec::Unit(k);
      motions.block<3, 1>(3 * v, 3 + k) = Vec::Unit(k).cross(arrays.points[v]);
    }
  return motions;
}

// Semidefinite; with bending and stretching its kernel is that of the rigid motions, bending alone lets a shell grow as
// well.
void test_kernel_of_shells()
{
  for(const Soup& soup : {bumpy_sphere(1), bumpy_patch(5, 4)})
  {
    const Arrays arrays = arrays_of(soup);
    const Eigen::MatrixXd hessian = shell_hessian(arrays, Shell_stiffness(), true);
    const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(hessian).eigenvalues();
    const double largest = eigenvalues[eigenvalues.size() - 1];
    GDP_CHECK(eigenvalues[0] > -1e-13 * largest && eigenvalues[5] < 1e-13 * largest && eigenvalues[6] > 1e-7 * largest);
    GDP_CHECK((hessian * rigid_motions(arrays)).cwiseAbs().maxCoeff() < 1e-12 * largest);

    const Eigen::MatrixXd bending = shell_hessian(arrays, Shell_stiffness{1, 0, 0}, true);
    Eigen::VectorXd growth(bending.rows());
    for(int v = 0; v < arrays.number_of_vertices(); ++v)
      growth.segment<3>(3 * v) = arrays.points[v];
    GDP_CHECK((bending * rigid_motions(arrays)).cwiseAbs().maxCoeff() < 1e-12 * largest);
    GDP_CHECK((bending * growth).cwiseAbs().maxCoeff() < 1e-12 * largest);
    GDP_CHECK((hessian * growth).cwiseAbs().maxCoeff() > 1e-4 * largest);
  }
}

void test_degenerate()
{
  Soup soup = bumpy_patch(6, 5);
  soup.points[8] = soup.points[9];
  for(int i = 0; i < 3; ++i)
    soup.points[24][i] = (soup.points[23][i] + soup.points[25][i]) / 2;
  soup.points.push_back({{1, 2, 3}});
  soup.triangles.push_back(soup.triangles[10]);
  const Arrays arrays = arrays_of(soup);
  GDP_CHECK(std::isfinite(largest(shell_hessian(arrays, Shell_stiffness(), true))));
  GDP_CHECK(std::isfinite(largest(modified_dirichlet_of(arrays))));
}

} // namespace

int main()
{
  test_modified_dirichlet_of_a_sphere();
  test_modified_dirichlet();
  test_gradients();
  test_shell_hessian();
  test_kernel_of_shells();
  test_degenerate();
  return GDP_TEST_RESULT();
}
