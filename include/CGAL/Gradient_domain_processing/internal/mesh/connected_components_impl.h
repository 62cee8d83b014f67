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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_CONNECTED_COMPONENTS_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_CONNECTED_COMPONENTS_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/mesh/connected_components.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Disjoint_sets.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE Components connected_components(const Indexed_triangles& mesh)
{
  const int n = mesh.number_of_vertices();
  Disjoint_sets sets(n);
  for(const auto& t : mesh.triangles)
  {
    sets.join(t[0], t[1]);
    sets.join(t[0], t[2]);
  }
  Components components;
  components.of_vertex.resize(n);
  std::vector<int> number(n, -1);
  for(int v = 0; v < n; ++v)
  {
    int& of_root = number[sets.root(v)];
    if(of_root < 0)
      of_root = components.count++;
    components.of_vertex[v] = of_root;
  }
  return components;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_CONNECTED_COMPONENTS_IMPL_H
