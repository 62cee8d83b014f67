// Copyright (c) 2026  The Gradient_domain_processing authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Gradient_domain_processing authors

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_RATIONAL_FILTER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_RATIONAL_FILTER_H

#include <CGAL/Gradient_domain_processing/internal/spectrum/Chebyshev_series.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// A transfer function as a number and rational functions, each with one pole on the negative axis, so that a signal is
// filtered without any harmonics, by one positive definite system for every pole. Knows how far it is from the function
// that was asked for.
class Rational_filter
{
  static constexpr int largest_degree = 1000;
  static constexpr double tolerance = 1e-8; // of the filters of Butterworth

  std::function<double(double)> m_function;
  double m_constant = 0, m_error_bound = 0;
  std::vector<Chebyshev_series> m_series;

public:
  double constant() const { return m_constant; }
  const std::vector<Chebyshev_series>& series() const { return m_series; }

  // Of the approximation, from 0 to infinity; infinite where there is none.
  double error_bound() const { return m_error_bound; }

  // What was asked for.
  double operator()(double mu) const { return m_function(mu); }

  // What is applied.
  double approximation(double mu) const
  {
    double sum = m_constant;
    for(const Chebyshev_series& s : m_series)
      sum += s(mu);
    return sum;
  }

  // How much the result may change at most, relative to the signal, for each relative error of a solution.
  double sensitivity() const
  {
    double sum = 0;
    for(const Chebyshev_series& s : m_series)
      sum += s.sensitivity();
    return sum;
  }

  int degree() const
  {
    int sum = 0;
    for(const Chebyshev_series& s : m_series)
      sum += s.degree();
    return sum;
  }

  // The same of eigenvalues that are multiplied by a factor.
  Rational_filter scaled(double factor) const
  {
    Rational_filter result = *this;
    for(Chebyshev_series& s : result.m_series)
      s = s.scaled(factor);
    result.m_function = [function = m_function, factor](double mu) { return function(mu / factor); };
    return result;
  }

  // 1 - h
  Rational_filter complement() const
  {
    Rational_filter result = sum_with(-1, Rational_filter(), 0);
    result.m_constant += 1;
    result.m_function = [function = m_function](double mu) { return 1 - function(mu); };
    return result;
  }

  // Without what another filter lets pass.
  Rational_filter minus(const Rational_filter& other) const
  {
    Rational_filter result = sum_with(1, other, -1);
    result.m_function = [a = m_function, b = other.m_function](double mu) { return a(mu) - b(mu); };
    return result;
  }

  // 1 / (1 + (mu / cut_off)^order), a half at the cut-off: what Butterworth filters are. At mu = q cut_off, q < 1, it
  // is within q^order of one, and at mu = cut_off / q within q^order of zero.
  static Rational_filter low_pass(double cut_off, int order)
  {
    return approximation_at({cut_off}, [=](double mu) { return 1 / (1 + std::pow(mu / cut_off, order)); }, tolerance);
  }

  // What is between the two cut-offs: around a center between them, or, where they are far apart, around each.
  static Rational_filter band_pass(double low, double high, int order)
  {
    const Rational_filter apart = low_pass(high, order).minus(low_pass(low, order));
    Rational_filter together = approximation_at({std::sqrt(low * high)}, apart.m_function, tolerance);
    return together.degree() > 0 && together.degree() <= apart.degree() ? together : apart;
  }

  // Chebyshev's series of a step at the cut-off, with damped coefficients: exactly what is asked for. damping(x) is one
  // at 0 and about zero at 1.
  static Rational_filter windowed_step(double cut_off, int degree, const std::function<double(double)>& damping)
  {
    const double pi = 4 * std::atan(1.);
    std::vector<double> coefficients(1, 0.5);
    for(int k = 1; k <= degree; ++k) // of 1 for t < 0, where the angle is above pi / 2
      coefficients.push_back(-2 * std::sin(k * pi / 2) / (k * pi) * damping(k / (degree + 1.)));
    Rational_filter filter;
    filter.m_series.emplace_back(cut_off, std::move(coefficients));
    filter.m_series[0].set_ends(1, 0);
    filter.m_function = filter.m_series[0];
    return filter;
  }

  // Any function, with a center near the given one that needs the least degree.
  static Rational_filter approximation_near(double center, const std::function<double(double)>& function,
                                            double largest_error)
  {
    std::vector<double> centers;
    for(int k = 0; k <= 4; ++k) // the given one first
      for(double factor : {std::pow(4., k), std::pow(4., -k)})
        centers.push_back(center * factor);
    return approximation_at(centers, function, largest_error);
  }

private:
  static Rational_filter approximation_at(const std::vector<double>& centers,
                                          const std::function<double(double)>& function, double largest_error)
  {
    Rational_filter best;
    best.m_function = function;
    best.m_error_bound = std::numeric_limits<double>::infinity();
    for(double center : centers)
    {
      for(int size = 32; size <= 4 * largest_degree && best.m_series.empty(); size *= 2)
        best.improve(center, size, largest_error);
      if(!best.m_series.empty())
        best.improve(center, 4 * best.m_series[0].degree() + 32, largest_error);
    }
    return best;
  }

  // Takes the series around a center if it keeps the bound, as is seen between the points of the interpolation, and has
  // a lower degree.
  void improve(double center, int size, double largest_error)
  {
    Chebyshev_series series = Chebyshev_series::interpolation(center, m_function, size);
    series.truncate(largest_error / 4);
    if(series.degree() > largest_degree || (!m_series.empty() && series.degree() >= m_series[0].degree()))
      return;
    series.set_at_zero(m_function(0));
    double bound = 2 * largest_difference(series, 4 * size);
    if(bound <= largest_error) // what is too narrow for these few points is seen by many
      bound = (std::max)(bound, 2 * largest_difference(series, 16 * largest_degree));
    if(!(bound <= largest_error))
      return;
    m_error_bound = bound;
    m_series.assign(1, series);
  }

  // On points of all scales. The bound is twice as much, for what is between them.
  double largest_difference(const Chebyshev_series& series, int number_of_points) const
  {
    const double pi = 4 * std::atan(1.);
    double most = 0;
    for(int j = 0; j <= number_of_points; ++j)
    {
      const double tangent = std::tan(j * pi / (2 * number_of_points));
      const double mu = series.center() * tangent * tangent;
      if(!std::isfinite(mu))
        continue;
      const double difference = std::abs(m_function(mu) - series(mu));
      if(!(difference <= most)) // not a number as well
        most = difference;
    }
    return most;
  }

  Rational_filter sum_with(double own, const Rational_filter& other, double others) const
  {
    Rational_filter result;
    result.m_constant = own * m_constant + others * other.m_constant;
    result.m_error_bound = m_error_bound + other.m_error_bound;
    for(const Chebyshev_series& s : m_series)
      result.add(s.times(own));
    for(const Chebyshev_series& s : other.m_series)
      result.add(s.times(others));
    return result;
  }

  // Series of one center are one, for one factorization.
  void add(const Chebyshev_series& series)
  {
    for(Chebyshev_series& s : m_series)
      if(s.center() == series.center())
        return s.add(series);
    m_series.push_back(series);
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_RATIONAL_FILTER_H
