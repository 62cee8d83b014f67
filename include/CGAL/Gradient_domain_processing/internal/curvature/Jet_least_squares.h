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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_JET_LEAST_SQUARES_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_JET_LEAST_SQUARES_H

#include <Eigen/Core>
#include <Eigen/QR>

#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// A model of `SvdTraits` for `Monge_via_jet_fitting`: QR with column pivoting in storage of bounded size, so that a fit
// neither iterates nor allocates. One type serves all degrees: each would be compiled with all of the fitting
// otherwise. It is a template, as what is made of it, so that only programs that fit jets compile them.
template <class FT_>
struct Jet_least_squares
{
  static constexpr int max_number_of_coefficients = 15; // degree 4
  static constexpr int max_number_of_points = 128;

  typedef FT_ FT;

  class Vector
    : public Eigen::Matrix<FT, Eigen::Dynamic, 1, Eigen::ColMajor, max_number_of_points, 1>
  {
  public:
    typedef Eigen::Matrix<FT, Eigen::Dynamic, 1, Eigen::ColMajor, max_number_of_points, 1> Eigen_type;

    Vector(std::size_t n) : Eigen_type(static_cast<Eigen::Index>(n)) { }
    void set(std::size_t i, FT value) { this->coeffRef(static_cast<Eigen::Index>(i)) = value; }
    FT* vector() { return this->data(); }
    Eigen_type& eigen_object() { return *this; }
  };

  class Matrix : public Eigen::Matrix<FT, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, max_number_of_points,
                                      max_number_of_coefficients>
  {
  public:
    typedef Eigen::Matrix<FT, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, max_number_of_points,
                          max_number_of_coefficients>
      Eigen_type;

    Matrix(std::size_t n, std::size_t m) : Eigen_type(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(m)) { }
    void set(std::size_t i, std::size_t j, FT value)
    {
      this->coeffRef(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = value;
    }
    const Eigen_type& eigen_object() const { return *this; }
  };

  // The solution replaces the first entries of `b`. The condition number is the usual estimate from the diagonal of R,
  // infinity for a matrix without full rank.
  static FT solve(const Matrix& m, Vector& b)
  {
    typedef Eigen::Matrix<FT, Eigen::Dynamic, 1, Eigen::ColMajor, max_number_of_coefficients, 1> Coefficients;
    const Eigen::ColPivHouseholderQR<typename Matrix::Eigen_type> qr(m.eigen_object());
    const Coefficients x = qr.solve(b.eigen_object());
    b.head(m.cols()) = x;

    const FT last = std::abs(qr.matrixQR()(m.cols() - 1, m.cols() - 1));
    return last > 0 ? std::abs(qr.matrixQR()(0, 0)) / last : std::numeric_limits<FT>::infinity();
  }
};

// (d + 1)(d + 2) / 2
inline std::size_t number_of_jet_coefficients(int degree)
{
  return std::size_t((degree + 1) * (degree + 2) / 2);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_JET_LEAST_SQUARES_H
