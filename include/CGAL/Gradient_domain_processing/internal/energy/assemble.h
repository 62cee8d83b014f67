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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_ASSEMBLE_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_ASSEMBLE_H

#include <CGAL/Gradient_domain_processing/internal/energy/element_matrices.h>
#include <CGAL/Gradient_domain_processing/internal/energy/sparsity_pattern.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>

#include <cstddef>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// body(v, dof, coefficients) for all degrees of freedom, in the order of the mesh.
template <class Body>
void for_each_degree_of_freedom(bool parallel, const Degrees_of_freedom& dofs, const Indexed_triangles& mesh,
                                const Triangle_metrics& metrics, const Body& body)
{
  for_each_block(parallel, dofs.of_vertex.size(), 1024, [&](std::size_t begin, std::size_t end) {
    const Block_coefficients coefficients(mesh, metrics, begin, end);
    for(std::size_t v = begin; v < end; ++v)
      if(dofs.of_vertex[v] >= 0)
        body(int(v), dofs.of_vertex[v], coefficients);
  });
}

// Fills the values of alpha M + beta S (eq. 2) into its pattern, a column at a time: columns do not touch each other.
// Answers whether rounding might decide on the constant of a component: the sum of a row, which holds the values' part,
// is all but lost in its diagonal.
bool assemble(const Indexed_triangles& mesh, const Triangle_metrics& metrics, const Energy_weights& weights,
              const Degrees_of_freedom& dofs, bool parallel, Sparse_matrix& matrix, bool is_system = true);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/energy/assemble_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_ASSEMBLE_H
