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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_EIGENPAIRS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_EIGENPAIRS_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/internal/spectrum/Block_lanczos.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Shifted_factor.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The lowest eigenpairs of A x = lambda B x, with symmetric A, bounded from below, and positive definite B, band by
// band after Vallet and Levy 2008: those around a shift, then a shift farther up. The factor at every shift tells how
// many eigenvalues are below it, and a band is done when it has them all: none of a multiple eigenvalue is missed.
class Lowest_eigenpairs
{
  static constexpr int band_size = 60;
  static constexpr double tolerance = 1e-10;

  const Eigen::SparseMatrix<double>& m_a;
  const Eigen::SparseMatrix<double>& m_b;
  Shifted_factor m_factor;
  std::vector<double> m_values; // increasing
  Eigen::MatrixXd m_vectors;    // as many columns, in the same order

public:
  Lowest_eigenpairs(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b) : m_a(a), m_b(b) {}

  Error_code find(int count, Eigenpairs& result)
  {
    const int n = int(m_a.rows());
    count = (std::min)(count, n);
    if(count == 0)
    {
      result.values.resize(0);
      result.vectors.resize(n, 0);
      return ok;
    }
    double sigma = 0;
    int below = 0;
    if(const Error_code code = first_shift(sigma, below))
      return code;
    while(true)
    {
      const int missing = below - number_below(sigma);
      if(missing < 0)
        return error_not_converged;
      if(missing == 0 && int(m_values.size()) >= count
         && (sigma > m_values[std::size_t(count) - 1] || int(m_values.size()) == n))
        break;
      if(const Error_code code = find_band(sigma, missing, (std::max)(count + 1 - int(m_values.size()), missing)))
        return code;
      sigma = next_shift(count, sigma);
      if(const Error_code code = factorize_near(sigma, below))
        return code;
    }
    result.values = Eigen::Map<const Eigen::VectorXd>(m_values.data(), count);
    result.vectors = m_vectors.leftCols(count);
    return ok;
  }

private:
  int number_below(double sigma) const
  {
    return int(std::lower_bound(m_values.begin(), m_values.end(), sigma) - m_values.begin());
  }

  // If it is an eigenvalue, as far as rounding knows, one a little higher: the factor cannot tell on which side that
  // is.
  Error_code factorize_near(double& sigma, int& below)
  {
    Error_code code = ok;
    for(int attempt = 0; attempt < 5; ++attempt)
    {
      const double unit = std::abs(sigma) + mean_spacing();
      code = m_factor.factorize(m_a, m_b, sigma);
      if(code == ok && distance_to_spectrum() > 1e-7 * unit)
        break;
      sigma += 1e-5 * unit;
    }
    below = code == ok ? m_factor.number_of_eigenvalues_below() : 0;
    return code;
  }

  // Of the shift, about, by inverse iteration.
  double distance_to_spectrum() const
  {
    Eigen::MatrixXd x(m_a.rows(), 1);
    for(Eigen::Index i = 0; i < x.rows(); ++i)
      x(i, 0) = double(i * 37 % 101) - 50; // orthogonal to nothing
    double distance = 0;
    for(int iteration = 0; iteration < 2; ++iteration)
    {
      const Eigen::MatrixXd image = m_factor.solve(m_b * x);
      const double norm = image.norm();
      if(!(norm > 0) || !std::isfinite(norm))
        return 0;
      distance = x.norm() / norm;
      x = image / norm;
    }
    return distance;
  }

  // Roughly, by Weyl's law: the mean of all eigenvalues, over their number.
  double mean_spacing() const
  {
    double a = 0, b = 0;
    for(int i = 0; i < int(m_a.rows()); ++i)
    {
      a += std::abs(m_a.coeff(i, i));
      b += m_b.coeff(i, i);
    }
    return a > 0 && b > 0 ? a / b / double(m_a.rows()) : 1;
  }

  // Below all eigenvalues.
  Error_code first_shift(double& sigma, int& below)
  {
    for(sigma = -5 * mean_spacing();; sigma *= 4)
    {
      if(const Error_code code = m_factor.factorize(m_a, m_b, sigma))
        return code;
      below = m_factor.number_of_eigenvalues_below();
      if(below == 0)
        return ok;
      if(!std::isfinite(4 * sigma))
        return error_cannot_solve_linear_system;
    }
  }

  // Half a band above the last, or, when there are enough, into the widest gap above the last of these, if there is
  // one, to see whether any is missing.
  double next_shift(int count, double last_shift) const
  {
    const int size = int(m_values.size());
    if(size > count || size == int(m_a.rows()))
    {
      int at = (std::min)(count, size - 1);
      for(int i = at; i < size; ++i)
        if(gap_below(i) > gap_below(at))
          at = i;
      if(size == int(m_a.rows()))
        return m_values.back() + (std::max)(1e-6 * std::abs(m_values.back()), mean_spacing());
      if(gap_below(at) > 1e-6 * (std::abs(m_values[std::size_t(at)]) + mean_spacing()))
        return m_values[std::size_t(at)] - gap_below(at) / 2;
    }
    const int back = (std::min)(band_size / 2, size - 1);
    const double span = m_values.back() - m_values[std::size_t(size - 1 - back)];
    // no simple number: not onto an eigenvalue of a regular mesh
    const double step = 0.9371 * (span > 0 ? span : mean_spacing());
    return (std::max)(m_values.back(), last_shift) + step;
  }

  double gap_below(int i) const { return i > 0 ? m_values[std::size_t(i)] - m_values[std::size_t(i) - 1] : 0; }

  // Two bands of what is known are kept out of the next; they begin at a wide gap, so that it is clear which those are.
  int first_to_deflate() const
  {
    const int size = int(m_values.size());
    int first = (std::max)(0, size - 2 * band_size);
    for(int i = first; first > 0 && i > size - 3 * band_size && i > 0; --i)
      if(gap_below(i) > gap_below(first))
        first = i;
    return first;
  }

  // Finds so many that are missing below the shift, and some above, a band in all or as many as are wanted.
  Error_code find_band(double sigma, int missing, int wanted)
  {
    const int first_known = first_to_deflate();
    const double low = first_known > 0 ? m_values[std::size_t(first_known)] - gap_below(first_known) / 2 : -HUGE_VAL;
    const Eigen::MatrixXd known = m_vectors.rightCols(m_vectors.cols() - first_known);
    Block_lanczos lanczos(m_b, m_factor, known, sigma, tolerance);
    wanted = (std::min)(wanted, (std::max)(band_size, missing));
    wanted = (std::min)(wanted, int(m_a.rows()) - int(m_values.size()));
    const int largest_basis = 10 * wanted + 200;
    while(true)
    {
      const bool can_grow = lanczos.can_grow() && lanczos.size() < largest_basis;
      if(can_grow)
        lanczos.grow();
      // to look costs as much as to grow
      if(can_grow && (lanczos.size() < wanted || lanczos.size() % 16 != 0) && lanczos.can_grow())
        continue;
      const Block_lanczos::Ritz_pairs pairs = lanczos.ritz_pairs();
      const std::vector<int> found = complete(pairs, sigma, low, missing);
      if(int(found.size()) >= wanted)
      {
        add(lanczos, pairs, found);
        return ok;
      }
      if(!can_grow)
        return error_not_converged;
    }
  }

  // Those of the Ritz pairs that have converged and leave none out: all below the shift, if there are as many as are
  // missing; above, up to the first that has not.
  static std::vector<int> complete(const Block_lanczos::Ritz_pairs& pairs, double sigma, double low, int missing)
  {
    std::vector<int> below, found;
    bool goes_on = true;
    for(int i = 0; i < int(pairs.values.size()); ++i)
    {
      const double value = pairs.values[std::size_t(i)];
      const bool has_converged = pairs.has_converged[std::size_t(i)];
      if(value < sigma)
      {
        if(has_converged && value > low && int(below.size()) < missing)
          below.push_back(i);
      }
      else if(goes_on && has_converged)
        found.push_back(i);
      else
        goes_on = false;
    }
    if(int(below.size()) < missing)
      return {};
    found.insert(found.end(), below.begin(), below.end());
    return found;
  }

  void add(const Block_lanczos& lanczos, const Block_lanczos::Ritz_pairs& pairs, const std::vector<int>& found)
  {
    Eigen::MatrixXd coefficients(pairs.coefficients.rows(), Eigen::Index(found.size()));
    for(std::size_t k = 0; k < found.size(); ++k)
      coefficients.col(Eigen::Index(k)) = pairs.coefficients.col(found[k]);
    const Eigen::MatrixXd vectors = lanczos.vectors(coefficients);

    std::vector<std::pair<double, int> > order;
    for(std::size_t k = 0; k < m_values.size(); ++k)
      order.emplace_back(m_values[k], int(k));
    for(std::size_t k = 0; k < found.size(); ++k)
      order.emplace_back(pairs.values[std::size_t(found[k])], int(m_values.size() + k));
    std::sort(order.begin(), order.end());
    Eigen::MatrixXd merged(m_a.rows(), Eigen::Index(order.size()));
    std::vector<double> values;
    for(std::size_t k = 0; k < order.size(); ++k)
    {
      const int from = order[k].second;
      values.push_back(order[k].first);
      if(from < int(m_values.size()))
        merged.col(Eigen::Index(k)) = m_vectors.col(from);
      else
        merged.col(Eigen::Index(k)) = vectors.col(from - int(m_values.size()));
    }
    m_values.swap(values);
    m_vectors.swap(merged);
  }
};

inline Error_code lowest_eigenpairs(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b,
                                    int count, Eigenpairs& result)
{
  return Lowest_eigenpairs(a, b).find(count, result);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_EIGENPAIRS_H
