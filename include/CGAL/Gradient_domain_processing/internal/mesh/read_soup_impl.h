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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_READ_SOUP_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_READ_SOUP_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/mesh/read_soup.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_for.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE void take_triangles(bool parallel, Lists& polygons, Indexed_triangles& mesh)
{
  for(int f = 0; f < polygons.size(); ++f)
    if(polygons.size(f) != 3)
      return;
  mesh.triangles.resize(std::size_t(polygons.size()));
  parallel_for(parallel, mesh.triangles.size(), [&](std::size_t f) {
    std::copy_n(polygons.begin(int(f)), 3, mesh.triangles[f].begin());
  });
  polygons = Lists();
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_READ_SOUP_IMPL_H
