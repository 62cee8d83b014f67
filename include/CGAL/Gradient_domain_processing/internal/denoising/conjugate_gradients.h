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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_CONJUGATE_GRADIENTS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_CONJUGATE_GRADIENTS_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Three channels and a zero, in single precision: a register of the processor.
typedef Eigen::Vector4f Vec3f;

inline Vec3f single(const Vec3& v) { return Vec3f(float(v[0]), float(v[1]), float(v[2]), 0.f); }
inline Vec3 as_double(const Vec3f& v) { return Vec3(v[0], v[1], v[2]); }

inline double inner_product(double a, double b) { return a * b; }
inline double inner_product(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double inner_product(const Vec3f& a, const Vec3f& b) { return a.dot(b); }

template <class Value>
struct Scalar_of
{
  typedef typename Value::Scalar type;
};
template <>
struct Scalar_of<double>
{
  typedef double type;
};

// Preconditioned by the diagonal, for a symmetric positive definite matrix whose product with p has row(p, i) as its
// i-th element. The channels of a vector share their step lengths, so that rotating them rotates the result. Elements
// with an inverse diagonal of 0 stay as they are. From x on, to a residual of `tolerance` relative to that of x = 0;
// says whether it came there.
template <class Value>
class Conjugate_gradients
{
  typedef typename Scalar_of<Value>::type Scalar;
  static constexpr std::size_t block_size = 4096;

  std::vector<Value> m_residual, m_direction, m_product;
  bool m_parallel;

public:
  explicit Conjugate_gradients(bool parallel) : m_parallel(parallel) {}

  template <class Row>
  bool operator()(const Row& row, const std::vector<Scalar>& inverse_diagonal, const std::vector<Value>& right,
                  double tolerance, int most_steps, std::vector<Value>& x)
  {
    const std::size_t n = x.size();
    m_residual.resize(n);
    m_direction.resize(n);
    m_product.resize(n);
    const double scale = sum(n, [&](std::size_t i) { return inverse_diagonal[i] * inner_product(right[i], right[i]); });
    double squares = sum(n, [&](std::size_t i) {
      m_residual[i] = right[i] - row(x, int(i));
      m_direction[i] = inverse_diagonal[i] * m_residual[i];
      return inner_product(m_direction[i], m_residual[i]);
    });
    for(int k = 0; k < most_steps && squares > tolerance * tolerance * scale; ++k)
    {
      const double curvature = sum(n, [&](std::size_t i) {
        m_product[i] = row(m_direction, int(i));
        return inverse_diagonal[i] == 0 ? 0. : inner_product(m_direction[i], m_product[i]);
      });
      const double last = squares;
      const Scalar step = Scalar(squares / curvature);
      squares = sum(n, [&](std::size_t i) {
        x[i] += step * m_direction[i];
        m_residual[i] -= step * m_product[i];
        return inverse_diagonal[i] * inner_product(m_residual[i], m_residual[i]);
      });
      const Scalar ratio = Scalar(squares / last);
      for_each_block(m_parallel, n, block_size, [&](std::size_t begin, std::size_t end) {
        for(std::size_t i = begin; i < end; ++i)
          m_direction[i] = inverse_diagonal[i] * m_residual[i] + ratio * m_direction[i];
      });
    }
    return squares <= tolerance * tolerance * scale;
  }

private:
  template <class Term>
  double sum(std::size_t n, const Term& term) const
  {
    return sum_over_blocks(m_parallel, n, block_size, 0., [&](std::size_t begin, std::size_t end) {
      double s = 0;
      for(std::size_t i = begin; i < end; ++i)
        s += term(i);
      return s;
    });
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_CONJUGATE_GRADIENTS_H
