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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_READ_GRAPH_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_READ_GRAPH_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/mesh/read_graph.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE Error_code check_faces(const Lists& polygons, Reading& reading, const Indexed_triangles& mesh)
{
  if(polygons.offsets.empty())
  {
    for(int f = 0; f < mesh.number_of_triangles(); ++f)
      if(*std::min_element(mesh.triangles[f].begin(), mesh.triangles[f].end()) < 0)
      {
        reading.culprit.face = f;
        return error_invalid_index;
      }
    return ok;
  }
  for(int f = 0; f < polygons.size(); ++f)
  {
    reading.culprit.face = f;
    if(polygons.size(f) < 3)
      return error_non_triangular_mesh;
    if(*std::min_element(polygons.begin(f), polygons.end(f)) < 0)
      return error_invalid_index;
  }
  reading.culprit.face = -1;
  return ok;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_READ_GRAPH_IMPL_H
