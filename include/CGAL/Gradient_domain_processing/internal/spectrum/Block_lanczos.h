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
// is made orthogonal to all before, and to eigenvectors that are known.
class Block_lanczos
{
  static constexpr int block_size = 4; // as many as CHOLMOD solves for at a time

  const Eigen::SparseMatrix<double>& m_b;
  const Shifted_factor& m_factor;
  const Eigen::MatrixXd& m_known;
  const double m_sigma, m_tolerance;
  std::mt19937 m_random;

  Eigen::MatrixXd m_basis;     // the last block is not multiplied yet
  Eigen::MatrixXd m_projected; // of the operator on the basis
  Eigen::MatrixXd m_coupling;  // from the last block that was multiplied to the next
  int m_size = 0;              // of the basis that was multiplied

public:
  struct Ritz_pairs
  {
    std::vector<double> values; // the eigenvalue nearest to the shift first
    std::vector<char> has_converged;
    Eigen::MatrixXd coefficients;
  };

  // `known` are eigenvectors not to be found again.
  Block_lanczos(const Eigen::SparseMatrix<double>& b, const Shifted_factor& factor, const Eigen::MatrixXd& known,
                double sigma, double tolerance)
    : m_b(b)
    , m_factor(factor)
    , m_known(known)
    , m_sigma(sigma)
    , m_tolerance(tolerance)
    , m_random(1)
  {
    m_basis.resize(b.rows(), block());
    for(int j = 0; j < block(); ++j)
      set_random(m_basis.col(j));
    Eigen::MatrixXd first = m_basis;
    m_basis.resize(b.rows(), 0);
    orthonormalize(first);
    m_basis = first;
  }

  int size() const { return m_size; }
  // Whether the basis can still grow.
  bool can_grow() const { return m_basis.cols() > m_size; }

  void grow()
  {
    const int next = int(m_basis.cols());
    Eigen::MatrixXd image = m_factor.solve(m_b * m_basis.rightCols(next - m_size));
    const Eigen::MatrixXd coefficients = project(image);
    m_projected.conservativeResize(next, next);
    m_projected.rightCols(next - m_size) = coefficients;
    m_projected.bottomLeftCorner(next - m_size, m_size) = coefficients.topRows(m_size).transpose();
    m_size = next;

    Eigen::MatrixXd residual = image;
    orthonormalize(residual);
    m_coupling = residual.transpose() * (m_b * image);
    m_basis.conservativeResize(Eigen::NoChange, next + residual.cols());
    m_basis.rightCols(residual.cols()) = residual;
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

  Eigen::MatrixXd vectors(const Eigen::MatrixXd& coefficients) const { return m_basis.leftCols(m_size) * coefficients; }

private:
  int block() const { return (std::min)(block_size, int(m_b.rows() - m_known.cols())); }

  template <class Vector>
  void set_random(Vector&& v)
  {
    for(Eigen::Index i = 0; i < v.size(); ++i)
      v[i] = double(m_random()) / 2147483648. - 1;
  }

  // Takes what is in the span of the basis and of what is known, and answers the coefficients of the former. Twice is
  // enough.
  Eigen::MatrixXd project(Eigen::MatrixXd& w) const
  {
    Eigen::MatrixXd coefficients = Eigen::MatrixXd::Zero(m_basis.cols(), w.cols());
    for(int pass = 0; pass < 2; ++pass)
    {
      const Eigen::MatrixXd image = m_b * w;
      if(m_known.cols() > 0)
        w.noalias() -= m_known * (m_known.transpose() * image);
      if(m_basis.cols() > 0)
      {
        const Eigen::MatrixXd part = m_basis.transpose() * image;
        w.noalias() -= m_basis * part;
        coefficients += part;
      }
    }
    return coefficients;
  }

  // Makes the columns orthonormal, to the basis as well. One that depends on others is replaced by a random one, or,
  // where there is no room for it, dropped.
  void orthonormalize(Eigen::MatrixXd& w)
  {
    int kept = 0;
    const Eigen::Index room = m_b.rows() - m_known.cols() - m_basis.cols();
    for(int j = 0; j < int(w.cols()) && kept < room; ++j)
    {
      Eigen::MatrixXd v = w.col(j);
      for(int attempt = 0; attempt < 3; ++attempt)
      {
        const double before = norm(v);
        for(int pass = 0; pass < 2; ++pass)
        {
          project(v);
          const Eigen::MatrixXd image = m_b * v;
          if(kept > 0)
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

  double norm(const Eigen::MatrixXd& v) const
  {
    return std::sqrt((std::max)(0., v.col(0).dot(Eigen::VectorXd(m_b * v.col(0)))));
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_SPECTRUM_BLOCK_LANCZOS_H
