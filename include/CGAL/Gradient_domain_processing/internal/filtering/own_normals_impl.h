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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_OWN_NORMALS_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_OWN_NORMALS_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/filtering/own_normals.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE Signal normals_by_row(const Indexed_triangles& mesh, bool parallel)
{
  const std::vector<Vec3> at_vertices = mesh.vertex_normals(parallel);
  Signal normals(mesh.number_of_rows(), 3);
  for(int row = 0; row < mesh.number_of_rows(); ++row)
    normals.row(row) = at_vertices[mesh.vertex_of(row)].transpose();
  return normals;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_OWN_NORMALS_IMPL_H
