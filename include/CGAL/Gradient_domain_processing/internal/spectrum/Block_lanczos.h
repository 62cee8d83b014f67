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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_BLOCK_LANCZOS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_BLOCK_LANCZOS_H

#include <CGAL/Gradient_domain_processing/internal/linear_solver/Shifted_factor.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Eigenvectors are columns, orthonormal in the inner product of B.
struct Eigenpairs
{
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

// The eigenpairs of (A, B) around a shift, by the Lanczos process for (A - sigma B)^-1 B, several vectors at a time: a
// multiple eigenvalue shows as often as a block has vectors, and the factor is read once for all of them. Every vector
// is made orthogonal to all before.
class Block_lanczos
{
  static constexpr int block_size = 3;

  const Eigen::SparseMatrix<double>& m_b;
  const Shifted_factor& m_factor;
  const double m_sigma, m_tolerance;
  std::mt19937 m_random;

  Eigen::MatrixXd m_basis;     // with room for more columns
  Eigen::MatrixXd m_projected; // of the operator on the basis
  Eigen::MatrixXd m_coupling;  // from the last block that was multiplied to the next
  int m_columns = 0;           // of the basis; the last block is not multiplied yet
  int m_size = 0;              // those that were multiplied

public:
  struct Ritz_pairs
  {
    std::vector<double> values; // the eigenvalue nearest to the shift first
    std::vector<char> has_converged;
    Eigen::MatrixXd coefficients;
  };

  Block_lanczos(const Eigen::SparseMatrix<double>& b, const Shifted_factor& factor, double sigma, double tolerance)
    : m_b(b)
    , m_factor(factor)
    , m_sigma(sigma)
    , m_tolerance(tolerance)
    , m_random(1)
  {
    Eigen::MatrixXd first(b.rows(), (std::min)(block_size, int(b.rows())));
    for(int j = 0; j < int(first.cols()); ++j)
      set_random(first.col(j));
    append(first);
  }

  int size() const { return m_size; }
  // Whether the basis can still grow.
  bool can_grow() const { return m_columns > m_size; }

  void grow()
  {
    const int next = m_columns, width = next - m_size, first = (std::max)(0, m_size - block_size);
    Eigen::MatrixXd image = m_factor.solve(m_b * m_basis.middleCols(m_size, width));
    const Eigen::VectorXd norms = norms_of(image);
    // it has no part along earlier blocks but for rounding, which append() takes out
    const Eigen::MatrixXd coefficients = project(image, first);
    m_projected.conservativeResize(next, next);
    m_projected.rightCols(width).setZero();
    m_projected.bottomRows(width).setZero();
    m_projected.bottomRightCorner(next - first, width) = coefficients;
    m_projected.bottomRightCorner(width, next - first) = coefficients.transpose();
    m_size = next;
    const Eigen::MatrixXd weighted = m_b * image;
    // where the basis is closed under the operator, rounding is left, which is no direction to go on in
    const Eigen::VectorXd left = norms_of(image);
    for(Eigen::Index k = 0; k < width; ++k)
      if(!(left[k] > 1e-13 * norms[k]))
        set_random(image.col(k));
    append(image);
    m_coupling = m_basis.middleCols(m_size, m_columns - m_size).transpose() * weighted;
  }

  Ritz_pairs ritz_pairs() const
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver((m_projected + m_projected.transpose()) / 2);
    const Eigen::VectorXd& inverses = solver.eigenvalues();
    std::vector<int> order(static_cast<std::size_t>(m_size));
    for(int i = 0; i < m_size; ++i)
      order[std::size_t(i)] = i;
    std::sort(order.begin(), order.end(), [&](int i, int j) { return std::abs(inverses[i]) > std::abs(inverses[j]); });

    Ritz_pairs pairs;
    pairs.coefficients.resize(m_size, m_size);
    const Eigen::MatrixXd residuals = m_coupling * solver.eigenvectors().bottomRows(m_coupling.cols());
    for(int k = 0; k < m_size; ++k)
    {
      const int i = order[std::size_t(k)];
      pairs.values.push_back(m_sigma + 1 / inverses[i]);
      pairs.has_converged.push_back(residuals.col(i).norm() <= m_tolerance * std::abs(inverses[i]));
      pairs.coefficients.col(k) = solver.eigenvectors().col(i);
    }
    return pairs;
  }

  Eigen::MatrixXd vectors(const Eigen::MatrixXd& coefficients) const
  {
    return m_basis.leftCols(coefficients.rows()) * coefficients;
  }

private:
  template <class Vector>
  void set_random(Vector&& v)
  {
    for(Eigen::Index i = 0; i < v.size(); ++i)
      v[i] = double(m_random()) / 2147483648. - 1;
  }

  // Takes what is in the span of the basis, or of the columns from one on, and answers the coefficients. A product of
  // matrices would copy the basis; products with vectors, some rows at a time that stay in the cache, do not.
  Eigen::MatrixXd project(Eigen::MatrixXd& w, int first = 0) const
  {
    constexpr Eigen::Index rows = 512;
    const Eigen::MatrixXd image = m_b * w;
    Eigen::MatrixXd coefficients = Eigen::MatrixXd::Zero(m_columns - first, w.cols());
    for(Eigen::Index row = 0; row < w.rows(); row += rows)
    {
      const Eigen::Index size = (std::min)(rows, w.rows() - row);
      const auto part = m_basis.block(row, first, size, coefficients.rows());
      for(Eigen::Index k = 0; k < w.cols(); ++k)
        coefficients.col(k).noalias() += part.transpose() * image.col(k).segment(row, size);
    }
    for(Eigen::Index row = 0; row < w.rows(); row += rows)
    {
      const Eigen::Index size = (std::min)(rows, w.rows() - row);
      const auto part = m_basis.block(row, first, size, coefficients.rows());
      for(Eigen::Index k = 0; k < w.cols(); ++k)
        w.col(k).segment(row, size).noalias() -= part * coefficients.col(k);
    }
    return coefficients;
  }

  // Appends the columns, orthonormal to all and to each other, given that they are about orthogonal to the basis.
  void append(Eigen::MatrixXd& w)
  {
    const Eigen::MatrixXd before = w;
    bool is_done = orthonormalize(w);
    if(is_done && m_columns > 0)
    {
      project(w);
      is_done = orthonormalize(w);
    }
    if(!is_done)
    {
      w = before;
      orthonormalize_one_by_one(w);
    }
    const int columns = m_columns + int(w.cols());
    if(columns > int(m_basis.cols()))
      m_basis.conservativeResize(m_b.rows(), columns + 16 * block_size);
    m_basis.middleCols(m_columns, w.cols()) = w;
    m_columns = columns;
  }

  // Among themselves. False where they depend on each other, or all but, or fill more than the space.
  bool orthonormalize(Eigen::MatrixXd& w) const
  {
    if(m_columns + w.cols() > m_b.rows())
      return false;
    const Eigen::MatrixXd products = w.transpose() * (m_b * w);
    const Eigen::LLT<Eigen::MatrixXd> factor(products);
    if(factor.info() != Eigen::Success)
      return false;
    const Eigen::MatrixXd lower = factor.matrixL();
    for(Eigen::Index j = 0; j < w.cols(); ++j)
      if(!(lower(j, j) > 1e-5 * std::sqrt(products(j, j))))
        return false;
    const Eigen::MatrixXd inverse =
      lower.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd::Identity(w.cols(), w.cols()));
    w = w * inverse.transpose();
    return true;
  }

  // One that depends on others is replaced by a random one, or, where there is no room for it, dropped.
  void orthonormalize_one_by_one(Eigen::MatrixXd& w)
  {
    int kept = 0;
    const Eigen::Index room = m_b.rows() - m_columns;
    for(int j = 0; j < int(w.cols()) && kept < room; ++j)
    {
      Eigen::MatrixXd v = w.col(j);
      for(int attempt = 0; attempt < 3; ++attempt)
      {
        const double before = norm(v);
        for(int pass = 0; pass < 3; ++pass)
        {
          project(v);
          const Eigen::MatrixXd image = m_b * v;
          v -= w.leftCols(kept) * (w.leftCols(kept).transpose() * image);
        }
        const double after = norm(v);
        if(after > 1e-8 * before)
        {
          w.col(kept++) = v / after;
          break;
        }
        set_random(v.col(0));
      }
    }
    w.conservativeResize(Eigen::NoChange, kept);
  }

  double norm(const Eigen::MatrixXd& v) const { return norms_of(v)[0]; }

  // Of the columns.
  Eigen::VectorXd norms_of(const Eigen::MatrixXd& w) const
  {
    const Eigen::MatrixXd image = m_b * w;
    Eigen::VectorXd norms(w.cols());
    for(Eigen::Index k = 0; k < w.cols(); ++k)
      norms[k] = std::sqrt((std::max)(0., w.col(k).dot(image.col(k))));
    return norms;
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_BLOCK_LANCZOS_H
