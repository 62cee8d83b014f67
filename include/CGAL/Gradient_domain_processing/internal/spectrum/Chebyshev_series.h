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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_CHEBYSHEV_SERIES_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_CHEBYSHEV_SERIES_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// A function of mu from 0 to infinity as a series of Chebyshev polynomials in t = (mu - center) / (mu + center), which
// is between -1 and 1: a rational function whose only pole is -center, as often as its degree. Waves far from the
// center are seen less sharply, those up to n times as long or as short still at degree n.
class Chebyshev_series
{
  double m_center = 1;
  std::vector<double> m_coefficients;

public:
  Chebyshev_series(double center, std::vector<double> coefficients)
    : m_center(center)
    , m_coefficients(std::move(coefficients))
  {
  }

  double center() const { return m_center; }
  const std::vector<double>& coefficients() const { return m_coefficients; }
  int degree() const { return int(m_coefficients.size()) - 1; }

  // The same of eigenvalues that are multiplied by a factor.
  Chebyshev_series scaled(double factor) const { return {m_center * factor, m_coefficients}; }

  Chebyshev_series times(double factor) const
  {
    Chebyshev_series result = *this;
    for(double& c : result.m_coefficients)
      c *= factor;
    return result;
  }

  // Another around the same center.
  void add(const Chebyshev_series& other)
  {
    m_coefficients.resize((std::max)(m_coefficients.size(), other.m_coefficients.size()), 0.);
    for(std::size_t k = 0; k < other.m_coefficients.size(); ++k)
      m_coefficients[k] += other.m_coefficients[k];
  }

  double operator()(double mu) const { return at((mu - m_center) / (mu + m_center)); }

  // By Clenshaw's recurrence.
  double at(double t) const
  {
    double b = 0, last = 0;
    for(std::size_t k = m_coefficients.size(); k-- > 1;)
    {
      const double next = m_coefficients[k] + 2 * t * b - last;
      last = b;
      b = next;
    }
    return m_coefficients[0] + t * b - last;
  }

  // How much the result may change, to first order, relative to the signal, if every solution is off by a part of its
  // vector: 2 of it at first, 4 later, and a deviation goes on as a Chebyshev polynomial of the second kind, which is
  // at most as large as its degree and one: 2 k^2 at degree k.
  double sensitivity() const
  {
    double sum = 0;
    for(std::size_t k = 1; k < m_coefficients.size(); ++k)
      sum += 2 * double(k) * double(k) * std::abs(m_coefficients[k]);
    return sum;
  }

  // Adds a constant, so that this is the value at mu = 0.
  void set_at_zero(double value) { m_coefficients[0] += value - at(-1); }

  // Adds a linear function of t, so that the values at mu = 0 and at infinity are these.
  void set_ends(double at_zero, double at_infinity)
  {
    m_coefficients.resize((std::max)(m_coefficients.size(), std::size_t(2)), 0.);
    const double low = at_zero - at(-1), high = at_infinity - at(1);
    m_coefficients[0] += (high + low) / 2;
    m_coefficients[1] += (high - low) / 2;
  }

  // Interpolates a function of t at the zeros of a polynomial.
  static Chebyshev_series interpolation(double center, const std::function<double(double)>& of_mu, int size)
  {
    const double pi = 4 * std::atan(1.);
    std::vector<double> values(static_cast<std::size_t>(size)), cosines(static_cast<std::size_t>(4 * size));
    for(int j = 0; j < 4 * size; ++j)
      cosines[std::size_t(j)] = std::cos(j * pi / (2 * size));
    for(int j = 0; j < size; ++j)
    {
      const double tangent = std::tan((j + 0.5) * pi / (2 * size)); // of half the angle
      values[std::size_t(j)] = of_mu(center / (tangent * tangent));
    }
    std::vector<double> coefficients(std::size_t(size), 0.);
    for(int k = 0; k < size; ++k)
    {
      for(int j = 0; j < size; ++j)
        coefficients[std::size_t(k)] +=
          values[std::size_t(j)] * cosines[std::size_t((long(k) * (2 * j + 1)) % (4 * size))];
      coefficients[std::size_t(k)] *= (k == 0 ? 1. : 2.) / size;
    }
    return {center, coefficients};
  }

  // Without the last coefficients, as many as sum up to no more than this; answers their sum, which bounds what it
  // changes.
  double truncate(double largest_change)
  {
    double sum = 0;
    while(m_coefficients.size() > 1 && sum + std::abs(m_coefficients.back()) <= largest_change)
    {
      sum += std::abs(m_coefficients.back());
      m_coefficients.pop_back();
    }
    return sum;
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_CHEBYSHEV_SERIES_H
