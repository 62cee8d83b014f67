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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_RESTORE_VOLUMES_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_RESTORE_VOLUMES_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Scales every component about its centroid (that of its surface) so that it encloses the volume it enclosed with the
// points `before`. A component that has none, or whose volume is the same, is left as it is. False where one has
// collapsed or is turned inside out.
bool restore_volumes(const Indexed_triangles& mesh, const std::vector<Vec3>& before, std::vector<Vec3>& after);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/mesh/restore_volumes_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_RESTORE_VOLUMES_H
