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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_POLYGON_FANS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_POLYGON_FANS_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The weights of the corners by which they make the virtual vertex of a polygon: the point for which the squares of the
// areas of the fan's triangles have the least sum (Bunge, Herholz, Kazhdan, Botsch 2020), and of all such weights those
// of least norm. A polygon that is a line or a point has equal weights.
Eigen::VectorXd virtual_vertex_weights(const std::vector<Vec3>& polygon);

// Makes the triangles of polygons given by rows: triangles as they are, others as fans. Points of virtual vertices
// follow those of the rows.
void fan_polygons(const Lists& polygons, Indexed_triangles& mesh);

// Sets the rows of virtual vertices from those of their corners.
void interpolate_virtual_rows(const Indexed_triangles& mesh, Signal& signal);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/mesh/polygon_fans_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_POLYGON_FANS_H
