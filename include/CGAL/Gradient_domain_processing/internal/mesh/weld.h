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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_WELD_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_WELD_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Makes one vertex of those on the border that share a place, within a tolerance relative to the extent: the sides of a
// seam move together. Answers how many vertices went into others. Corners and borders are those of before, and to be
// made anew if any did.
int weld_border(double tolerance, Indexed_triangles& mesh);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/mesh/weld_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_WELD_H
