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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_SPECTRUM_SLICE_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_SPECTRUM_SLICE_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Shifted_factor.h>
#include <CGAL/Gradient_domain_processing/internal/spectrum/Block_lanczos.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The eigenpairs of A x = lambda B x around one shift, with the number of eigenvalues below it, which the factor tells.
// On both sides those next to the shift are known without a gap: up to the first that has not converged.
class Spectrum_slice
{
  static constexpr double tolerance = 1e-10;

  const Eigen::SparseMatrix<double>& m_a;
  const Eigen::SparseMatrix<double>& m_b;
  double m_sigma = 0;
  int m_below = 0;
  std::unique_ptr<Shifted_factor> m_factor;
  std::unique_ptr<Block_lanczos> m_lanczos;
  Block_lanczos::Ritz_pairs m_pairs;
  std::vector<int> m_left, m_right; // of the pairs, the nearest to the shift first

public:
  Spectrum_slice(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b) : m_a(a), m_b(b) {}

  double sigma() const { return m_sigma; }
  int below() const { return m_below; }
  int above() const { return int(m_a.rows()) - m_below; }
  int number_on_left() const { return int(m_left.size()); }
  int number_on_right() const { return int(m_right.size()); }

  // Counted from one, away from the shift.
  double on_left(int i) const { return m_pairs.values[std::size_t(m_left[std::size_t(i) - 1])]; }
  double on_right(int i) const { return m_pairs.values[std::size_t(m_right[std::size_t(i) - 1])]; }

  // If the shift is an eigenvalue, as far as rounding knows, takes one a little higher: the factor cannot tell on which
  // side that is.
  Error_code factorize_near(double sigma, double spacing)
  {
    m_factor = std::make_unique<Shifted_factor>();
    Error_code code = ok;
    for(int attempt = 0; attempt < 5; ++attempt)
    {
      const double unit = std::abs(sigma) + spacing;
      code = m_factor->factorize(m_a, m_b, sigma);
      if(code == ok && distance_to_spectrum() > 1e-7 * unit)
        break;
      if(attempt == 4)
        return code == ok ? error_not_converged : code;
      sigma += 1e-5 * unit;
    }
    m_sigma = sigma;
    m_below = code == ok ? m_factor->number_of_eigenvalues_below() : 0;
    return code;
  }

  int size() const { return m_lanczos ? m_lanczos->size() : 0; }
  bool can_grow() const { return !m_lanczos || (m_lanczos->can_grow() && m_lanczos->size() < 1000); }

  // Until so many are known on both sides, or as many as there are, or the basis cannot grow.
  void find(int left, int right)
  {
    left = (std::min)(left, below());
    right = (std::min)(right, above());
    if(!m_lanczos && left + right > 0)
      m_lanczos = std::make_unique<Block_lanczos>(m_b, *m_factor, m_sigma, tolerance);
    while((number_on_left() < left || number_on_right() < right) && can_grow() && !is_far())
    {
      // a multiple eigenvalue may fill it, a few copies at a time; to look often costs a dense problem each time
      const int step = (std::max)(12, m_lanczos->size() / 4), goal = (std::max)(m_lanczos->size() + step, left + right);
      while(m_lanczos->size() < goal && can_grow())
        m_lanczos->grow();
      list_converged();
    }
  }

  // Whether all eigenvalues are on the right, and so far away for how near they are to each other that none has been
  // told from the others; but for what rounding leaves of them.
  bool is_far() const
  {
    if(below() > 0 || !m_right.empty() || m_pairs.values.size() < 2 || m_pairs.values[0] <= m_sigma)
      return false;
    const double distance = m_pairs.values[0] - m_sigma;
    return distance > 100 * spread() && spread() > 1e-12 * distance;
  }

  // About: no eigenvalue is known to be lower, and half of what was found is so far above it.
  double lowest() const { return m_pairs.values[0]; }
  double spread() const { return m_pairs.values[m_pairs.values.size() / 2] - m_pairs.values[0]; }

  // Those from so many on the left to so many on the right, increasing, as columns.
  void take(int left, int right, std::vector<double>& values, Eigen::MatrixXd& vectors) const
  {
    std::vector<int> taken(m_left.rend() - left, m_left.rend());
    taken.insert(taken.end(), m_right.begin(), m_right.begin() + right);
    Eigen::MatrixXd coefficients(m_pairs.coefficients.rows(), Eigen::Index(taken.size()));
    for(std::size_t k = 0; k < taken.size(); ++k)
    {
      values.push_back(m_pairs.values[std::size_t(taken[k])]);
      coefficients.col(Eigen::Index(k)) = m_pairs.coefficients.col(taken[k]);
    }
    vectors.resize(m_a.rows(), 0);
    if(!taken.empty())
      vectors = m_lanczos->vectors(coefficients);
  }

  void release()
  {
    m_lanczos.reset();
    m_factor.reset();
    m_pairs.coefficients.resize(0, 0);
  }

private:
  void list_converged()
  {
    m_pairs = m_lanczos->ritz_pairs();
    m_left.clear();
    m_right.clear();
    bool goes_on_left = true, goes_on_right = true;
    for(int i = 0; i < int(m_pairs.values.size()); ++i)
    {
      const bool is_left = m_pairs.values[std::size_t(i)] < m_sigma;
      bool& goes_on = is_left ? goes_on_left : goes_on_right;
      goes_on = goes_on && m_pairs.has_converged[std::size_t(i)];
      if(goes_on)
        (is_left ? m_left : m_right).push_back(i);
    }
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
      const Eigen::MatrixXd image = m_factor->solve(m_b * x);
      const double norm = image.norm();
      if(!(norm > 0) || !std::isfinite(norm))
        return 0;
      distance = x.norm() / norm;
      x = image / norm;
    }
    return distance;
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_SPECTRUM_SLICE_H
