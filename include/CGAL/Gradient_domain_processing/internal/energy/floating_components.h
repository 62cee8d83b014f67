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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_FLOATING_COMPONENTS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_FLOATING_COMPONENTS_H

#include <CGAL/Gradient_domain_processing/internal/energy/Energy_weights.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/border_edges.h>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// A term of second order connects as well, and needs so many constrained vertices where no gradients count; 0 for none.
bool has_floating_component(const Indexed_triangles& mesh, const Energy_weights& weights,
                            int constraints_of_second_order, const std::vector<char>& is_constrained);

// The same of the border's curves.
bool has_floating_border(const Indexed_triangles& mesh, const std::vector<Border_edge>& edges,
                         const Energy_weights& weights, const std::vector<char>& is_constrained);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/energy/floating_components_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_FLOATING_COMPONENTS_H
