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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_BORDER_ENERGY_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_BORDER_ENERGY_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/internal/energy/Energy_weights.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/border_edges.h>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

template <class Target_field>
Error_code displace_curves(const Indexed_triangles& mesh, std::vector<Border_edge> edges, const Energy_weights& weights,
                           const std::vector<char>& is_constrained, const Target_field& target, Signal& displacement);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/energy/border_energy_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_BORDER_ENERGY_H
