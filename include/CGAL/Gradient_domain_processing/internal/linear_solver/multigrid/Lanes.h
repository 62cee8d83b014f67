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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_LANES_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_LANES_H

#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// What the preconditioner computes in: single precision, all channels of a degree of freedom together, three of them
// beside an idle fourth, so that they fill a register.
template <int K>
struct Lanes
{
  static constexpr int width = K == 3 ? 4 : K;
  typedef Eigen::Array<float, width, 1> Value;

  static Eigen::Map<Value> at(std::vector<float>& values, std::size_t i)
  {
    return Eigen::Map<Value>(values.data() + width * i);
  }
  static Eigen::Map<const Value> at(const std::vector<float>& values, std::size_t i)
  {
    return Eigen::Map<const Value>(values.data() + width * i);
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_MULTIGRID_LANES_H
