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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_TRIANGLE_METRIC_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_TRIANGLE_METRIC_H

#include <CGAL/license/Gradient_domain_processing.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Gradient_domain_processing {

/*!
 * \ingroup PkgGradientDomainProcessingRef
 *
 * The metric of one triangle: a symmetric positive definite tensor \f$ g \f$, constant on the triangle, in the basis
 * \f$ t_1 = v_1 - v_0,\ t_2 = v_2 - v_0 \f$, where \f$ v_0 \f$ is the source and \f$ v_1 \f$ the target of
 * `halfedge(f)`, and
 * \f$ v_2 \f$ the target of the next halfedge (paper, appendix A). The embedding of the triangle in space has
 * \f$ g_{ij} = \langle t_i, t_j \rangle \f$.
 *
 * The tensor is kept as its three *corner products* \f$ c_i \f$, the inner products of the two edges that leave corner
 * \f$ i \f$ (\f$ c_0 = g_{12},\ c_1 = g_{11} - g_{12},\ c_2 = g_{22} - g_{12} \f$), and \f$ \sqrt{\det g} \f$, twice
 * the area. The cotangent of corner \f$ i \f$ is \f$ c_i / \sqrt{\det g} \f$; from slivers it comes out with all its
 * digits, which
 * \f$ g^{-1} \f$ would not.
 *
 * Units: those of squared length.
 */
class Triangle_metric
{
  std::array<double, 3> m_corner_products;
  double m_sqrt_det;

  Triangle_metric(double c0, double c1, double c2, double sqrt_det)
    : m_corner_products{{c0, c1, c2}}, m_sqrt_det(sqrt_det)
  {}

public:
  /// \name Construction
  /// @{

  /// constructs the metric of the right triangle whose two legs have length one.
  Triangle_metric() : Triangle_metric(0, 1, 1, 1) {}

  /// constructs the tensor \f$ (g_{11}, g_{12}; g_{12}, g_{22}) \f$. Whether it is positive definite is said by
  /// `is_valid()`.
  Triangle_metric(double g11, double g12, double g22)
    : Triangle_metric(g12, g11 - g12, g22 - g12, std::sqrt(determinant(g11, g12, g22)))
  {}

  /// returns the metric of the triangle \f$ (v_0, v_1, v_2) \f$ in space.
  static Triangle_metric embedding(const Eigen::Vector3d& v0, const Eigen::Vector3d& v1, const Eigen::Vector3d& v2)
  {
    const Eigen::Vector3d t1 = v1 - v0, t2 = v2 - v0, t3 = v2 - v1;
    return Triangle_metric(t1.dot(t2), -t1.dot(t3), t2.dot(t3), t1.cross(t2).norm());
  }

  /// returns the metric in which squared lengths along the orthonormal tangent directions \f$ d_1, d_2 \f$ of the
  /// triangle are multiplied by \f$ s_1, s_2 \f$: \f$ g = J^T (s_1 d_1 d_1^T + s_2 d_2 d_2^T) J \f$ (paper, section
  /// 2.3).
  static Triangle_metric stretched(const Eigen::Vector3d& v0, const Eigen::Vector3d& v1, const Eigen::Vector3d& v2,
                                   double s1, const Eigen::Vector3d& d1, double s2, const Eigen::Vector3d& d2)
  {
    const Eigen::Vector3d t1 = v1 - v0, t2 = v2 - v0, t3 = v2 - v1;
    const auto product = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
      return s1 * a.dot(d1) * b.dot(d1) + s2 * a.dot(d2) * b.dot(d2);
    };
    return Triangle_metric(product(t1, t2), -product(t1, t3), product(t2, t3),
                           std::sqrt(s1 * s2) * t1.cross(t2).norm());
  }

  /// returns the metric of the equilateral triangle of edge length `length`.
  static Triangle_metric equilateral(double length = 1)
  {
    const double half = length * length / 2;
    return Triangle_metric(half, half, half, std::sqrt(3.) * half);
  }

  /// @}
  /// \name Access
  /// @{

  /// returns \f$ g_{11} = |t_1|^2 \f$.
  double g11() const { return m_corner_products[0] + m_corner_products[1]; }
  /// returns \f$ g_{12} = \langle t_1, t_2 \rangle \f$.
  double g12() const { return m_corner_products[0]; }
  /// returns \f$ g_{22} = |t_2|^2 \f$.
  double g22() const { return m_corner_products[0] + m_corner_products[2]; }

  /// returns the inner product of the two edges that leave corner `i`, 0, 1 or 2.
  double corner_product(int i) const { return m_corner_products[i]; }

  /// returns \f$ \sqrt{\det g} \f$, twice the area.
  double sqrt_determinant() const { return m_sqrt_det; }

  /// returns the area of the triangle under this metric.
  double area() const { return m_sqrt_det / 2; }

  /// returns the largest squared edge length.
  double max_squared_length() const
  {
    const auto& c = m_corner_products;
    return (std::max)({c[0] + c[1], c[0] + c[2], c[1] + c[2]});
  }

  /// returns whether all entries are finite and the tensor is positive definite.
  bool is_valid() const
  {
    return std::isfinite(m_corner_products[0]) && std::isfinite(m_corner_products[1])
           && std::isfinite(m_corner_products[2]) && std::isfinite(m_sqrt_det) && m_sqrt_det > 0 && g11() > 0
           && g22() > 0;
  }

  /// @}
  /// \name Change
  /// @{

  /// returns the metric \f$ c\,g \f$: areas are multiplied by `c`, the Dirichlet energy stays as it is.
  Triangle_metric scaled(double c) const
  {
    return Triangle_metric(c * m_corner_products[0], c * m_corner_products[1], c * m_corner_products[2],
                           c * m_sqrt_det);
  }

  /// returns the metric with its area raised, where needed, to `ratio` times the largest squared edge length. The
  /// stiffness of a degenerate triangle stays finite by it; any other triangle is returned unchanged to the bit.
  Triangle_metric with_area_bounded_below(double ratio) const
  {
    Triangle_metric result(*this);
    result.m_sqrt_det = (std::max)(m_sqrt_det, ratio * max_squared_length());
    return result;
  }

  /// @}

private:
  // a c - b^2 without cancellation of the rounded products
  static double determinant(double a, double b, double c)
  {
    const double bb = b * b;
    return std::fma(a, c, -bb) - std::fma(b, b, -bb);
  }
};

} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_TRIANGLE_METRIC_H
