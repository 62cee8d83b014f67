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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_MORTON_ORDER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_MORTON_ORDER_H

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The points along a Morton curve: neighbors in space become neighbors in memory. Radix sort, ten bits at a time.
std::vector<int> morton_order(const std::vector<Eigen::Vector3d>& points, bool parallel);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/mesh/morton_order_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_MORTON_ORDER_H
