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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_OFFSET_TO_VOLUMES_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_OFFSET_TO_VOLUMES_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Normals determine a closed surface up to an offset: parallel surfaces have the same. Moves every component along its
// normals, so that its faces are moved alike, until it encloses the volume it enclosed with the points `before`.
// Returns how many components would be more than emptied or do not get there; these are left as they are, as those
// without a volume.
int offset_to_volumes(const Indexed_triangles& mesh, const std::vector<Vec3>& before, bool parallel,
                      std::vector<Vec3>& after);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/mesh/offset_to_volumes_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_OFFSET_TO_VOLUMES_H
