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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_CONNECTED_COMPONENTS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_CONNECTED_COMPONENTS_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The connected component of every vertex, numbered by their lowest vertices.
struct Components
{
  std::vector<int> of_vertex;
  int count = 0;
};

Components connected_components(const Indexed_triangles& mesh);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/mesh/connected_components_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_CONNECTED_COMPONENTS_H
