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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_RIGHT_HAND_SIDE_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_RIGHT_HAND_SIDE_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/energy/right_hand_side.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE void move_to_right_hand_side(const Indexed_triangles& mesh, const Triangle_metrics& metrics,
                                             const Energy_weights& weights, const Degrees_of_freedom& dofs,
                                             const Signal& displacement, bool parallel, Eigen::MatrixXd& residual)
{
  for_each_degree_of_freedom(parallel, dofs, mesh, metrics,
                             [&](int v, int row, const Block_coefficients& coefficients) {
                               const auto subtract = [&](int vertex, double entry) {
                                 if(dofs.of_vertex[vertex] < 0)
                                   for(int channel = 0; channel < int(residual.cols()); ++channel)
                                     residual(row, channel) -= entry * displacement(vertex, channel);
                               };
                               for(const int* c = mesh.corners.begin(v); c != mesh.corners.end(v); ++c)
                               {
                                 const Row_entries entries = row_entries(mesh, coefficients(*c / 3), weights, *c);
                                 const auto others = mesh.opposite_vertices(*c);
                                 subtract(others[0], entries.va);
                                 subtract(others[1], entries.vb);
                               }
                             });
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_RIGHT_HAND_SIDE_IMPL_H
