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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_RECENTER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_RECENTER_H

#include <CGAL/Gradient_domain_processing/internal/energy/element_matrices.h>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Targets are differences along edges, so what they ask for sums up to zero: on a component without constraints the
// mean of the change, weighted by the values' part of the system, is zero. Where rounding has lost that, it is brought
// back.
void recenter(const Indexed_triangles& mesh, const Triangle_metrics& metrics, const Energy_weights& weights,
              const std::vector<char>& is_constrained, Signal& displacement);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/energy/recenter_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_RECENTER_H
