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
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE void take_triangles(Lists& polygons, Indexed_triangles& mesh)
{
  for(int f = 0; f < polygons.size(); ++f)
    if(polygons.size(f) != 3)
      return;
  mesh.triangles.resize(polygons.size());
  for(int f = 0; f < polygons.size(); ++f)
    for(int i = 0; i < 3; ++i)
      mesh.triangles[f][i] = polygons.items[3 * f + i];
  polygons = Lists();
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_READ_SOUP_IMPL_H
