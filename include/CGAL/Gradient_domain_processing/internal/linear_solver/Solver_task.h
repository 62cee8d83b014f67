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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_SOLVER_TASK_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_SOLVER_TASK_H

#include <cstddef>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// What linear solvers shall do.
struct Solver_task
{
  std::size_t unknowns = 0;
  int channels = 3;
  int matrices = 1;              // of one pattern
  int solutions_of_each = 1;
  double gradient_weight = 1e-4; // of unit area, relative to the value weight
  bool has_metric = false;       // other than that of the embedding
  bool is_of_second_order = false;
  unsigned cores = 1;
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_SOLVER_TASK_H
