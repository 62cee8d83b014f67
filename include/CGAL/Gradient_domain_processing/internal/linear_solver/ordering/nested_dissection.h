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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_NESTED_DISSECTION_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_NESTED_DISSECTION_H

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The order in which to eliminate the vertices of a graph so that its Cholesky factor stays sparse: order[k] is the
// k-th. The graph comes in compressed rows, symmetric and without loops. Same result on every run and any number of
// threads. `go_on` is asked often, by the calling thread only; where it answers false, the order is empty.
std::vector<int> nested_dissection(const std::vector<Eigen::Vector3d>& points, const std::vector<int>& offsets,
                                   const std::vector<int>& neighbors, bool parallel,
                                   const std::function<bool()>& go_on = {});

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/nested_dissection_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_NESTED_DISSECTION_H
