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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_ELIMINATION_ORDER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_ELIMINATION_ORDER_H

#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/Degrees_of_freedom.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>

#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The elimination tree of a symmetric matrix (Liu 1986): parent[j] is the row of the first entry below the diagonal in
// column j of the Cholesky factor, -1 for a root. for_each_earlier(j, visit) visits the i < j with an entry (i, j).
template <class For_each_earlier>
std::vector<int> elimination_tree(int n, const For_each_earlier& for_each_earlier)
{
  std::vector<int> parent(n, -1), ancestor(n, -1);
  for(int j = 0; j < n; ++j)
    for_each_earlier(j, [&](int i) {
      while(ancestor[i] != -1 && ancestor[i] != j)
        i = std::exchange(ancestor[i], j);
      if(ancestor[i] == -1)
        ancestor[i] = parent[i] = j;
    });
  return parent;
}

// The nodes of a forest with parent[j] > j, every one after all below it. As an order of elimination it fills in as the
// order of the numbers does, and columns of the factor with like entries come together: a solver need not permute the
// matrix for that.
std::vector<int> postorder(const std::vector<int>& parent);

// The vertices of a graph that are solved for, in the order in which they are eliminated. `go_on` is asked often, by
// the calling thread only; where it answers false, the order is empty.
Degrees_of_freedom elimination_order(const std::vector<Vec3>& points, const Lists& graph,
                                     const std::vector<char>& is_solved_for, bool parallel,
                                     const std::function<bool()>& go_on = {});

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/linear_solver/ordering/elimination_order_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_ELIMINATION_ORDER_H
