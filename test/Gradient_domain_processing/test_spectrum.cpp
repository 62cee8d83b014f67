// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Eigenpairs and transfer functions, on arrays.

#include "test_arrays.h"

#include <iostream>
#include <CGAL/Gradient_domain_processing/internal/higher_order/bilaplacian.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/constrained_minimum.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/hessian_energy.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/modified_dirichlet.h>
#include <CGAL/Gradient_domain_processing/Default_sparse_linear_solver.h>
#include <CGAL/Gradient_domain_processing/internal/spectrum/Spectral_system.h>
#include <CGAL/Gradient_domain_processing/internal/spectrum/eigenpairs.h>
#include <CGAL/Gradient_domain_processing/internal/spectrum/filter_by_harmonics.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

using namespace gdp_test;
using namespace GDP::internal;

namespace {

Sparse stiffness_matrix(const Arrays& arrays)
{
  return modified_dirichlet(arrays, Metrics(), std::vector<Vec3>(arrays.points.size(), Vec3(0, 0, 1)), true);
}

Eigen::VectorXd masses_of(const Arrays& arrays)
{
  const std::vector<double> masses = lumped_masses(arrays, Metrics(), true);
  return Eigen::Map<const Eigen::VectorXd>(masses.data(), Eigen::Index(masses.size()));
}

Sparse diagonal(const Eigen::VectorXd& values)
{
  Sparse matrix(values.size(), values.size());
  for(int i = 0; i < values.size(); ++i)
    matrix.insert(i, i) = values[i];
  matrix.makeCompressed();
  return matrix;
}

void check_pairs(const Sparse& a, const Sparse& b, const Eigenpairs& pairs, double tolerance,
                 double of_products = 1e-11)
{
  const Eigen::MatrixXd residual = a * pairs.vectors - b * pairs.vectors * pairs.values.asDiagonal();
  GDP_CHECK_NEAR(residual.cwiseAbs().maxCoeff(), 0, tolerance);
  const Eigen::MatrixXd products = pairs.vectors.transpose() * (b * pairs.vectors);
  GDP_CHECK_NEAR((products - Eigen::MatrixXd::Identity(products.rows(), products.cols())).cwiseAbs().maxCoeff(), 0,
                 of_products);
}

// l (l + 1) as often as 2 l + 1, of second order.
void test_sphere()
{
  double last = 0;
  for(int level : {2, 3})
  {
    const Arrays sphere = arrays_of(icosphere(level));
    const Sparse stiffness = stiffness_matrix(sphere), mass = diagonal(masses_of(sphere));
    Eigenpairs pairs;
    GDP_CHECK(lowest_eigenpairs(stiffness, mass, 25, pairs) == GDP::ok);
    GDP_CHECK(pairs.values.size() == 25);
    check_pairs(stiffness, mass, pairs, 1e-7);
    double error = 0;
    for(int l = 0, j = 0; l < 5; ++l)
      for(int m = 0; m < 2 * l + 1; ++m, ++j)
        error = (std::max)(error, std::abs(pairs.values[j] - l * (l + 1.)) / 20);
    GDP_CHECK_NEAR(error, 0, level == 2 ? 0.11 : 0.03);
    GDP_CHECK(last == 0 || std::abs(error / last - 0.25) < 0.05);
    last = error;
  }
}

// All eigenvalues against a dense solver, over several bands, whatever the operator; a flat torus has each many times.
void test_bands()
{
  const Arrays patch = arrays_of(bumpy_patch(14, 13)), torus = arrays_of(gdp_test::torus(16, 16));
  Metrics flat;
  flat.given.assign(torus.triangles.size(), GDP::Triangle_metric());
  const std::vector<Vec3> up(torus.points.size(), Vec3(0, 0, 1));
  const Sparse matrices[4] = {stiffness_matrix(patch),
                              hessian_energy(patch, Metrics(), GDP::Hessian_kind::SQUARED_HESSIAN, true),
                              hessian_energy(patch, Metrics(), GDP::Hessian_kind::CURVED_HESSIAN, true),
                              modified_dirichlet(torus, flat, up, true)};
  for(int i = 0; i < 4; ++i)
  {
    const Sparse mass = diagonal(i < 3 ? masses_of(patch) : Eigen::VectorXd(Eigen::VectorXd::Ones(256)));
    const Eigen::VectorXd expected =
      Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(matrices[i]), Eigen::MatrixXd(mass))
        .eigenvalues();
    for(int count : {1, 150})
    {
      Eigenpairs pairs;
      if(!GDP_CHECK(lowest_eigenpairs(matrices[i], mass, count, pairs) == GDP::ok))
        std::cerr << "  operator " << i << ", " << count << " pairs" << std::endl;
      GDP_CHECK(pairs.values.size() == count);
      if(pairs.values.size() == count)
        GDP_CHECK_NEAR((pairs.values - expected.head(count)).cwiseAbs().maxCoeff() / expected[149], 0, 1e-9);
    }
  }
}

// Those nearest to a shift against a dense solver, wherever that is, on an eigenvalue as well: by few and by several
// slices; on one thread to the bit the same.
void test_shifts()
{
  const Arrays sphere = arrays_of(icosphere(2)), patch = arrays_of(bumpy_patch(17, 16));
  for(const Arrays& arrays : {sphere, patch})
  {
    const Sparse stiffness = stiffness_matrix(arrays), mass = diagonal(masses_of(arrays));
    const Eigen::VectorXd all =
      Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(stiffness), Eigen::MatrixXd(mass))
        .eigenvalues();
    const int n = int(all.size());
    for(double shift : {-1., 0., all[1], 6., 13.3, all[n / 2], all[n - 3], 2 * all[n - 1]})
      for(int count : {1, 7, 90})
      {
        Eigenpairs pairs, on_one_thread;
        if(!GDP_CHECK(nearest_eigenpairs(stiffness, mass, shift, count, pairs) == GDP::ok))
          std::cerr << "  shift " << shift << ", " << count << " pairs" << std::endl;
        if(!GDP_CHECK(pairs.values.size() == count))
          continue;
        check_pairs(stiffness, mass, pairs, 1e-6, 1e-10);
        std::vector<double> distances, found;
        for(int j = 0; j < n; ++j)
          distances.push_back(std::abs(all[j] - shift));
        for(int j = 0; j < count; ++j)
          found.push_back(std::abs(pairs.values[j] - shift));
        std::sort(distances.begin(), distances.end());
        std::sort(found.begin(), found.end());
        for(int j = 0; j < count; ++j)
          GDP_CHECK_NEAR(found[std::size_t(j)], distances[std::size_t(j)], 1e-4 * (1 + std::abs(shift)));
        GDP_CHECK(nearest_eigenpairs(stiffness, mass, shift, count, on_one_thread, false) == GDP::ok);
        GDP_CHECK(on_one_thread.values == pairs.values && on_one_thread.vectors == pairs.vectors);
      }
  }
}

// A narrow cluster far from zero is told apart, from below and by a shift next to it or in it.
void test_far_clusters()
{
  const int n = 1500;
  Eigen::VectorXd values(n), ones = Eigen::VectorXd::Ones(n);
  for(int i = 0; i < n; ++i)
    values[i] = 1e6 + (i * 7 % n) / 500.;
  const Sparse a = diagonal(values), b = diagonal(ones);
  Eigenpairs pairs;
  GDP_CHECK(lowest_eigenpairs(a, b, 70, pairs) == GDP::ok && pairs.values.size() == 70);
  check_pairs(a, b, pairs, 1e-6, 1e-10);
  for(int j = 0; j < int(pairs.values.size()); ++j)
    GDP_CHECK_NEAR(pairs.values[j], 1e6 + j / 500., 1e-7);
  for(double shift : {0., 999999., 1e6 + 1.0007})
  {
    GDP_CHECK(nearest_eigenpairs(a, b, shift, 20, pairs) == GDP::ok && pairs.values.size() == 20);
    const double first = shift < 1e6 ? 1e6 : 1e6 + 0.982;
    for(int j = 0; j < int(pairs.values.size()); ++j)
      GDP_CHECK_NEAR(pairs.values[j], first + j / 500., 1e-7);
  }
  // all may be the same, of a space of any size
  for(int size : {30, 100, 121, 300})
  {
    const Sparse same = diagonal(Eigen::VectorXd::Constant(size, 1e6)), one = diagonal(Eigen::VectorXd::Ones(size));
    GDP_CHECK(lowest_eigenpairs(same, one, 5, pairs) == GDP::ok && pairs.values.size() == 5);
    for(int j = 0; j < int(pairs.values.size()); ++j)
      GDP_CHECK_NEAR(pairs.values[j], 1e6, 1e-6);
  }
}

// Filters columns by vertex.
GDP::Error_code apply(const Rational_filter& filter, const Arrays& arrays, Eigen::MatrixXd& columns)
{
  Progress progress;
  Spectral_system system(any_linear_solver(GDP::Default_sparse_linear_solver()), true);
  if(const GDP::Error_code code =
       system.assemble_matrices(arrays, Metrics(), std::vector<char>(arrays.points.size(), 0), progress))
    return code;
  const std::vector<int>& vertex = system.degrees_of_freedom().vertex;
  Eigen::MatrixXd values(columns.rows(), columns.cols());
  for(std::size_t i = 0; i < vertex.size(); ++i)
    values.row(Eigen::Index(i)) = columns.row(vertex[i]);
  if(const GDP::Error_code code = system.apply(filter, progress, values))
    return code;
  for(std::size_t i = 0; i < vertex.size(); ++i)
    columns.row(vertex[i]) = values.row(Eigen::Index(i));
  return GDP::ok;
}

// The transfer function measured on harmonics is the one that is stated, which is a half at the cut-offs and keeps the
// mean.
void test_rational_filters()
{
  const Arrays sphere = arrays_of(icosphere(3));
  const Sparse stiffness = stiffness_matrix(sphere);
  const Eigen::VectorXd masses = masses_of(sphere);
  const Sparse mass = diagonal(masses);
  Eigenpairs pairs;
  GDP_CHECK(lowest_eigenpairs(stiffness, mass, 40, pairs) == GDP::ok);
  for(int order = 1; order <= 5; ++order)
  {
    const auto low = [order](double mu, double cut_off) { return 1 / (1 + std::pow(mu / cut_off, order)); };
    const Rational_filter low_pass = Rational_filter::low_pass(12, order);
    const Rational_filter band_pass = Rational_filter::band_pass(5, 20, order);
    const Rational_filter filters[4] = {low_pass, low_pass.complement(), band_pass, band_pass.complement()};
    for(int i = 0; i < 4; ++i)
    {
      Eigen::MatrixXd filtered = pairs.vectors;
      GDP_CHECK(apply(filters[i], sphere, filtered) == GDP::ok);
      for(int j = 0; j < 40; ++j)
      {
        const double mu = (std::max)(0., pairs.values[j]);
        const double band = low(mu, 20) - low(mu, 5);
        const double expected = i == 0 ? low(mu, 12) : i == 1 ? 1 - low(mu, 12) : i == 2 ? band : 1 - band;
        GDP_CHECK_NEAR(filters[i](mu), expected, 1e-12);
        GDP_CHECK_NEAR(filters[i].approximation(mu), expected, filters[i].error_bound());
        GDP_CHECK_NEAR(pairs.vectors.col(j).dot(mass * filtered.col(j)), expected, filters[i].error_bound() + 1e-11);
        GDP_CHECK_NEAR((filtered.col(j) - expected * pairs.vectors.col(j)).cwiseAbs().maxCoeff(), 0, 1e-7);
      }
    }
    GDP_CHECK(filters[0].error_bound() <= 1e-8 && filters[2].error_bound() <= 2e-8);
    GDP_CHECK(order > 1 || filters[0].degree() == 1);
    GDP_CHECK(filters[0].degree() <= 13 * order);
    GDP_CHECK_NEAR(filters[0](12), 0.5, 1e-13);
    GDP_CHECK_NEAR(filters[0](0), 1, 1e-13);
    GDP_CHECK(filters[0](24) <= std::pow(0.5, order) && filters[0](6) >= 1 - std::pow(0.5, order));
  }

  // the same by harmonics, for a signal of which they make up a part, and the rest is kept
  const Rational_filter filter = Rational_filter::low_pass(12, 4);
  const Eigen::MatrixXd signal =
    sampled(sphere, [](const Vec& p) { return std::exp(2 * p.x()) + std::sin(9 * p.y()); });
  Eigen::MatrixXd solved = signal;
  GDP_CHECK(apply(filter, sphere, solved) == GDP::ok);
  GDP_CHECK_NEAR(masses.dot(solved.col(0) - signal.col(0)), 0, 1e-10);
  const Eigen::MatrixXd by_harmonics = filter_by_harmonics(pairs, mass, signal, filter, 0.25);
  const Eigen::MatrixXd parts = pairs.vectors.transpose() * (mass * (by_harmonics - solved));
  GDP_CHECK_NEAR(parts.cwiseAbs().maxCoeff(), 0, 1e-7);
  const Eigen::MatrixXd rest = signal - pairs.vectors * (pairs.vectors.transpose() * (mass * signal));
  const Eigen::MatrixXd rest_filtered =
    by_harmonics - pairs.vectors * (pairs.vectors.transpose() * (mass * by_harmonics));
  GDP_CHECK_NEAR((rest_filtered - 0.25 * rest).cwiseAbs().maxCoeff(), 0, 1e-10);
}

// The bound that is stated is kept, also where it takes another center; where it cannot be kept, there is none.
void test_approximations()
{
  const Arrays sphere = arrays_of(icosphere(3));
  const Sparse stiffness = stiffness_matrix(sphere), mass = diagonal(masses_of(sphere));
  Eigenpairs pairs;
  GDP_CHECK(lowest_eigenpairs(stiffness, mass, 40, pairs) == GDP::ok);
  const std::function<double(double)> functions[4] = {
    [](double mu) { return std::exp(-0.1 * mu); }, [](double mu) { return mu / (1 + 0.1 * mu + 0.02 * mu * mu); },
    [](double mu) { return std::exp(-std::pow(mu - 12, 2) / 40) * std::cos(mu / 6); },
    [](double mu) { return (std::max)(0., 1 - mu / 30); }};
  for(int i = 0; i < 4; ++i)
    for(double largest_error : {1e-2, 1e-3, 1e-7})
    {
      const Rational_filter filter = Rational_filter::approximation_near(10, functions[i], largest_error);
      if(i == 3 && largest_error < 1e-2)
      {
        GDP_CHECK(std::isinf(filter.error_bound())); // it has a kink
        continue;
      }
      GDP_CHECK(filter.error_bound() <= largest_error);
      double most = 0;
      for(double mu = 1e-4; mu < 1e7; mu *= 1.003)
        most = (std::max)(most, std::abs(filter.approximation(mu) - functions[i](mu)));
      GDP_CHECK(most <= filter.error_bound());
      GDP_CHECK_NEAR(filter.approximation(0), functions[i](0), 1e-12);
      Eigen::MatrixXd filtered = pairs.vectors;
      GDP_CHECK(apply(filter, sphere, filtered) == GDP::ok);
      for(int j = 0; j < 40; ++j)
        GDP_CHECK_NEAR(pairs.vectors.col(j).dot(mass * filtered.col(j)), functions[i]((std::max)(0., pairs.values[j])),
                       filter.error_bound() + 1e-11);
    }
  GDP_CHECK(Rational_filter::band_pass(5, 20, 4).series().size() == 1);
  // what has one center is factorized once, and adds up
  const Rational_filter twice = Rational_filter::low_pass(5, 2).minus(Rational_filter::low_pass(5, 6));
  GDP_CHECK(twice.series().size() == 1 && twice.degree() == Rational_filter::low_pass(5, 6).degree());
  for(double mu : {0., 3., 5., 8., 200.})
    GDP_CHECK_NEAR(twice.approximation(mu), 1 / (1 + std::pow(mu / 5, 2)) - 1 / (1 + std::pow(mu / 5, 6)), 2e-8);
  GDP_CHECK(Rational_filter::band_pass(0.01, 100, 4).series().size() == 2);
  const auto exponential = [](double mu) { return std::exp(-mu); };
  GDP_CHECK(Rational_filter::approximation_near(1, exponential, 1e-8).degree()
            <= Rational_filter::approximation_near(16, exponential, 1e-8).degree() + 5);
  GDP_CHECK(std::isinf(Rational_filter::approximation_near(1, [](double mu) { return mu; }, 1e-6).error_bound()));
  GDP_CHECK(std::isinf(Rational_filter::approximation_near(1, [](double) { return std::nan(""); }, 1).error_bound()));
}

// Every solution off by a part of its vector, along any of the harmonics, changes the result by no more than the
// sensitivity says; and by a good deal of it where all go the same way.
void test_sensitivity()
{
  const double error = 1e-7;
  for(const Rational_filter& filter :
      {Rational_filter::low_pass(1, 1), Rational_filter::low_pass(1, 4), Rational_filter::band_pass(0.01, 100, 4),
       Rational_filter::windowed_step(1, 40, [](double) { return 1.; })})
  {
    double most = 0;
    for(double mu : {0., 0.05, 0.9, 1., 1.2, 30., 1e9})
      for(int seed = 0; seed < 40; ++seed)
      {
        std::mt19937 random(static_cast<unsigned>(seed));
        double sum = filter.constant(), expected = sum;
        for(const Chebyshev_series& series : filter.series())
        {
          const double t = (mu - series.center()) / (mu + series.center());
          double last = 0, now = 1;
          sum += series.coefficients()[0];
          for(int degree = 1; degree <= series.degree(); ++degree)
          {
            const double sign = seed < 2 ? (seed == 0 ? 1 : degree % 2 ? 1 : -1) : random() % 2 ? 1 : -1;
            double next = now - 2 * ((1 - t) / 2 * now + sign * error * std::abs(now));
            next = degree > 1 ? 2 * next - last : next;
            sum += series.coefficients()[std::size_t(degree)] * next;
            last = now;
            now = next;
          }
          expected += series(mu);
        }
        most = (std::max)(most, std::abs(sum - expected));
      }
    GDP_CHECK(most <= 1.01 * error * filter.sensitivity());
    GDP_CHECK(most > 0.02 * error * filter.sensitivity());
  }
}

// A square whose border is constrained: pi^2 (i^2 + j^2), counted from one.
void test_constrained()
{
  const Arrays square = arrays_of(grid(20, 20));
  std::vector<int> free_index;
  int count = 0;
  for(char is_on_border : square.is_on_border)
    free_index.push_back(is_on_border ? -1 : count++);
  const auto whole = [](const Sparse& lower) { return Sparse(lower.selfadjointView<Eigen::Lower>()); };
  const Sparse stiffness = whole(free_block(stiffness_matrix(square), free_index, count));
  const Sparse mass = whole(free_block(diagonal(masses_of(square)), free_index, count));
  Eigenpairs pairs;
  GDP_CHECK(lowest_eigenpairs(stiffness, mass, 4, pairs) == GDP::ok);
  const double expected[4] = {2, 5, 5, 8}, pi = 4 * std::atan(1.);
  for(int j = 0; j < 4; ++j)
    GDP_CHECK_NEAR(pairs.values[j] / (pi * pi * expected[j]), 1, 0.02);
}

} // namespace

int main()
{
  test_sphere();
  test_bands();
  test_shifts();
  test_far_clusters();
  test_rational_filters();
  test_approximations();
  test_sensitivity();
  test_constrained();
  return GDP_TEST_RESULT();
}
