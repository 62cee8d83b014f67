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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_DUAL_SYSTEM_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_DUAL_SYSTEM_H

#include <CGAL/Gradient_domain_processing/internal/denoising/Dual_graph.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/conjugate_gradients.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The solution g of (A + L) g = A f for values on triangles: A holds their masses, L is the Laplacian of the dual graph
// with weights for its edges, as often as each of the two triangles sees them.
template <class Value>
class Dual_system
{
  typedef typename Scalar_of<Value>::type Scalar;

  const Dual_graph& m_dual;
  std::vector<Scalar> m_inverse_diagonal;
  Conjugate_gradients<Value> m_solver;
  bool m_parallel;

public:
  std::vector<Scalar> masses;
  std::vector<std::array<Scalar, 3> > weights; // 0 where there is no neighbor

  Dual_system(const Dual_graph& dual, bool parallel)
    : m_dual(dual), m_inverse_diagonal(dual.size()), m_solver(parallel), m_parallel(parallel), weights(dual.size())
  {}

  // `right` is A f; x is where to start.
  bool solve(const std::vector<Value>& right, double tolerance, int most_steps, std::vector<Value>& x)
  {
    parallel_for(m_parallel, weights.size(), [&](std::size_t f) {
      m_inverse_diagonal[f] = 1 / (masses[f] + weights[f][0] + weights[f][1] + weights[f][2]);
    });
    return m_solver([&](const std::vector<Value>& p, int f) {
      Value product = masses[f] * p[f];
      for(int i = 0; i < 3; ++i)
        if(m_dual.neighbor(f, i) >= 0)
          product += weights[f][i] * (p[f] - p[m_dual.neighbor(f, i)]);
      return product;
    }, m_inverse_diagonal, right, tolerance, most_steps, x);
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_DENOISING_DUAL_SYSTEM_H
