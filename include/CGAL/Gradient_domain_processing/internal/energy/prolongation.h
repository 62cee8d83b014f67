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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_PROLONGATION_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_PROLONGATION_H

#include <CGAL/Gradient_domain_processing/internal/energy/sparsity_pattern.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The degrees of freedom followed by the virtual vertices of polygons.
Degrees_of_freedom with_virtual_vertices(const Degrees_of_freedom& dofs, const Indexed_triangles& mesh);

// Virtual vertices as means of degrees of freedom: with the matrix P of this function, an energy with matrix A of all
// vertices becomes P^T A P of the polygons' corners alone. It is symmetric and positive definite with A, and as exact
// on linear functions.
Sparse_matrix prolongation(const Degrees_of_freedom& dofs, const Indexed_triangles& mesh);

// Displacements of virtual vertices from those of the corners.
void interpolate_virtual_vertices(const Indexed_triangles& mesh, Signal& displacement);

// The neighbors of every corner of polygons: all corners of its polygons. Virtual vertices have none.
Lists rings_of_polygons(const Lists& rings, const Indexed_triangles& mesh);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/energy/prolongation_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_PROLONGATION_H
