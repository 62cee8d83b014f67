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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_OWN_NORMALS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_OWN_NORMALS_H

#include <CGAL/Gradient_domain_processing/parameters.h>
#include <CGAL/Gradient_domain_processing/internal/filtering/Filter.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/signals.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Sums of area-weighted normals, by row.
Signal normals_by_row(const Indexed_triangles& mesh, bool parallel);

// The normals that the surface has at its vertices, by row: the caller's, or those above.
template <class Surface, class NamedParameters>
Error_code read_own_normals(const NamedParameters& np, const Surface_elements<Surface>& elements, Filter& filter,
                            Signal& normals)
{
  const Indexed_triangles& mesh = filter.mesh();
  if constexpr (Has_parameter<CGAL::internal_np::vertex_normal_map_t, NamedParameters>::value)
    return read_vectors(parameter(np, CGAL::internal_np::vertex_normal_map, 0), elements, mesh, filter.culprit,
                        normals);
  else
  {
    normals = normals_by_row(mesh, filter.system.parallel);
    return ok;
  }
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/filtering/own_normals_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_OWN_NORMALS_H
