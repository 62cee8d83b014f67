// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_ENERGY_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_ENERGY_H

#include "test_shapes.h"

#include <Eigen/Dense>

#include <vector>

namespace gdp_test {

// The energy in dense matrices, straight from its definition, with nothing of the package: metric tensors are inverted,
// integrals are sums over monomials of barycentric coordinates. For small meshes without degenerate triangles.
struct Dense_energy
{
  const Mesh& mesh;
  std::vector<double> alpha, beta, lambda; // at vertices, on faces, on faces; beta is a squared length
  std::vector<char> is_fixed;
  std::vector<Eigen::Matrix2d> metric;

  explicit Dense_energy(const Mesh& m, double a = 1, double b = 0, double l = 0)
    : mesh(m), alpha(m.number_of_vertices(), a), beta(m.number_of_faces(), b), lambda(m.number_of_faces(), l),
      is_fixed(m.number_of_vertices(), 0)
  {
    for(Face f : mesh.faces())
      metric.push_back(frame(f).transpose() * frame(f));
  }

  // t1 and t2
  Eigen::Matrix<double, 3, 2> frame(Face f) const
  {
    const auto c = corners(mesh, f);
    Eigen::Matrix<double, 3, 2> t;
    t << vec(mesh.point(c[1])) - vec(mesh.point(c[0])), vec(mesh.point(c[2])) - vec(mesh.point(c[0]));
    return t;
  }

  static Eigen::Matrix<double, 2, 3> differences()
  {
    Eigen::Matrix<double, 2, 3> g;
    g << -1, 1, 0, -1, 0, 1;
    return g;
  }

  double area(Face f) const { return std::sqrt(metric[f].determinant()) / 2; }

  // alpha M
  Eigen::MatrixXd mass() const
  {
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(alpha.size(), alpha.size());
    for(Face f : mesh.faces())
    {
      const auto c = corner_numbers(mesh, f);
      for(int i = 0; i < 3; ++i)
        for(int j = 0; j < 3; ++j)
          for(int k = 0; k < 3; ++k)
          {
            int power[3] = {0, 0, 0};
            for(int x : {i, j, k})
              ++power[x];
            const double factorial[4] = {1, 1, 2, 6};
            m(c[i], c[j]) +=
              alpha[c[k]] * 2 * area(f) * factorial[power[0]] * factorial[power[1]] * factorial[power[2]] / 120;
          }
    }
    return m;
  }

  // beta S
  Eigen::MatrixXd stiffness() const
  {
    Eigen::MatrixXd s = Eigen::MatrixXd::Zero(alpha.size(), alpha.size());
    for(Face f : mesh.faces())
    {
      const auto c = corner_numbers(mesh, f);
      const Eigen::Matrix3d local = beta[f] * area(f) * differences().transpose() * metric[f].inverse() * differences();
      for(int i = 0; i < 3; ++i)
        for(int j = 0; j < 3; ++j)
          s(c[i], c[j]) += local(i, j);
    }
    return s;
  }

  // lambda grad f as covectors, two rows a face
  Eigen::MatrixXd scaled_gradient(const Eigen::MatrixXd& f) const
  {
    Eigen::MatrixXd v(2 * mesh.number_of_faces(), f.cols());
    for(Face t : mesh.faces())
    {
      const auto c = corner_numbers(mesh, t);
      for(int i = 0; i < 2; ++i)
        v.row(2 * t + i) = lambda[t] * (f.row(c[i + 1]) - f.row(c[0]));
    }
    return v;
  }

  // alpha |f - g|^2 + beta |v - grad g|^2 in all channels
  double operator()(const Eigen::MatrixXd& f, const Eigen::MatrixXd& v, const Eigen::MatrixXd& g) const
  {
    const Eigen::MatrixXd d = f - g;
    double sum = (d.transpose() * mass() * d).trace();
    for(Face t : mesh.faces())
    {
      const auto c = corner_numbers(mesh, t);
      Eigen::MatrixXd rest = v.middleRows(2 * t, 2);
      for(int i = 0; i < 2; ++i)
        rest.row(i) -= g.row(c[i + 1]) - g.row(c[0]);
      sum += beta[t] * area(t) * (rest.transpose() * metric[t].inverse() * rest).trace();
    }
    return sum;
  }

  // the minimum, with `f` at fixed vertices
  Eigen::MatrixXd minimum(const Eigen::MatrixXd& f, const Eigen::MatrixXd& v) const
  {
    const Eigen::MatrixXd m = mass(), a = m + stiffness();
    Eigen::MatrixXd right = m * f;
    for(Face t : mesh.faces())
    {
      const auto c = corner_numbers(mesh, t);
      const Eigen::MatrixXd local =
        beta[t] * area(t) * differences().transpose() * metric[t].inverse() * v.middleRows(2 * t, 2);
      for(int i = 0; i < 3; ++i)
        right.row(c[i]) += local.row(i);
    }
    return dirichlet(a, right, f, is_fixed);
  }
  Eigen::MatrixXd minimum(const Eigen::MatrixXd& f) const { return minimum(f, scaled_gradient(f)); }

  // a g = right at the free rows, g = f at the fixed ones; a free row of zeros keeps f as well
  static Eigen::MatrixXd dirichlet(const Eigen::MatrixXd& a, const Eigen::MatrixXd& right, const Eigen::MatrixXd& f,
                                   const std::vector<char>& is_fixed)
  {
    std::vector<int> free_rows;
    for(int i = 0; i < a.rows(); ++i)
      if(!is_fixed[i] && a.row(i).cwiseAbs().maxCoeff() > 0)
        free_rows.push_back(i);
    const int n = int(free_rows.size());
    Eigen::MatrixXd reduced(n, n), rest(n, f.cols()), g = f;
    for(int i : free_rows)
      g.row(i).setZero();
    for(int i = 0; i < n; ++i)
    {
      rest.row(i) = right.row(free_rows[i]) - a.row(free_rows[i]) * g;
      for(int j = 0; j < n; ++j)
        reduced(i, j) = a(free_rows[i], free_rows[j]);
    }
    const Eigen::MatrixXd x = reduced.ldlt().solve(rest);
    for(int i = 0; i < n; ++i)
      g.row(free_rows[i]) = x.row(i);
    return g;
  }
};

} // namespace gdp_test

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_ENERGY_H
