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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_IS_ORIENTED_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_IS_ORIENTED_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Whether the area vectors of every component of a surface without border cancel. Only then is what it encloses the
// same seen from any origin; a triangle the wrong way around, or a wall between two rooms, has no side that is inside.
bool is_oriented(const Indexed_triangles& mesh);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/mesh/is_oriented_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_IS_ORIENTED_H
