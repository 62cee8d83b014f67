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

#include <cmath>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// A transfer function as a sum of partial fractions, so that a signal is filtered without any harmonics, by one
// positive definite system a fraction. Those of second degree have a pair of complex poles, and are real with S M^-1 S
// in the matrix.
class Rational_filter
{
public:
  // weight * (constant - slope z) / (z^2 + 2 shift z + 1), z = mu / cut_off; with first degree, weight / (z + 1)
  struct Fraction
  {
    double cut_off, weight, slope, shift;
    bool has_second_degree;
  };

private:
  double m_constant = 0;
  std::vector<Fraction> m_fractions; // those of one cut-off follow each other

public:
  double constant() const { return m_constant; }
  const std::vector<Fraction>& fractions() const { return m_fractions; }

  // The same of eigenvalues that are multiplied by a factor.
  Rational_filter scaled(double factor) const
  {
    Rational_filter result = *this;
    for(Fraction& fraction : result.m_fractions)
      fraction.cut_off *= factor;
    return result;
  }

  // 1 / (1 + (mu / cut_off)^order), a half at the cut-off: what Butterworth filters are. At mu = q cut_off, q < 1, it
  // is within q^order of one, and at mu = cut_off / q within q^order of zero.
  static Rational_filter low_pass(double cut_off, int order)
  {
    Rational_filter filter;
    filter.add_low_pass(cut_off, order, 1);
    return filter;
  }

  static Rational_filter high_pass(double cut_off, int order)
  {
    Rational_filter filter;
    filter.m_constant = 1;
    filter.add_low_pass(cut_off, order, -1);
    return filter;
  }

  // What is between the two cut-offs.
  static Rational_filter band_pass(double low, double high, int order)
  {
    Rational_filter filter;
    filter.add_low_pass(high, order, 1);
    filter.add_low_pass(low, order, -1);
    return filter;
  }

  static Rational_filter band_stop(double low, double high, int order)
  {
    Rational_filter filter;
    filter.m_constant = 1;
    filter.add_low_pass(high, order, -1);
    filter.add_low_pass(low, order, 1);
    return filter;
  }

  // The transfer function, exactly.
  double operator()(double mu) const
  {
    double sum = m_constant;
    for(const Fraction& fraction : m_fractions)
    {
      const double z = mu / fraction.cut_off;
      sum += fraction.has_second_degree
               ? fraction.weight * (1 - fraction.slope * z) / (z * z + 2 * fraction.shift * z + 1)
               : fraction.weight / (z + 1);
    }
    return sum;
  }

private:
  // The poles of 1 / (1 + z^n) are the n-th roots of -1, in pairs but for -1 itself.
  void add_low_pass(double cut_off, int order, double sign)
  {
    const double pi = 4 * std::atan(1.);
    for(int k = 0; 2 * k + 1 < order; ++k)
    {
      const double cosine = std::cos(pi * (2 * k + 1) / order);
      m_fractions.push_back({cut_off, 2 * sign / order, cosine, -cosine, true});
    }
    if(order % 2 == 1)
      m_fractions.push_back({cut_off, sign / order, 0, 0, false});
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_RATIONAL_FILTER_H
