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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_SECOND_ORDER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_SECOND_ORDER_H

#include <CGAL/Gradient_domain_processing/internal/energy/sparsity_pattern.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>
#include <CGAL/Gradient_domain_processing/internal/metric/Triangle_metrics.h>

#include <functional>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The matrix gamma Q of a term of second order, made for a mesh and its metrics, over all vertices and stored as a
// whole. None: there is no such term.
typedef std::function<Sparse_matrix(const Indexed_triangles&, const Triangle_metrics&, bool parallel)>
  Second_order_energy;

// The vertices within two edges of every vertex: its neighbors in Q.
Lists second_rings(const Lists& rings);

// The rows and columns of the degrees of freedom, in their order.
Sparse_matrix restricted(const Sparse_matrix& matrix, const Degrees_of_freedom& dofs);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/energy/second_order_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_SECOND_ORDER_H
