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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_MODIFIED_DIRICHLET_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_MODIFIED_DIRICHLET_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/higher_order/modified_dirichlet.h>
#include <CGAL/Gradient_domain_processing/internal/energy/element_matrices.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/Element_matrices.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_for.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The three vertices of every triangle.
CGAL_GDP_INLINE Lists triangle_stencils(const Indexed_triangles& mesh)
{
  Lists stencils;
  stencils.offsets.reserve(mesh.triangles.size() + 1);
  stencils.items.reserve(3 * mesh.triangles.size());
  stencils.offsets.push_back(0);
  for(const auto& t : mesh.triangles)
  {
    stencils.items.insert(stencils.items.end(), t.begin(), t.end());
    stencils.offsets.push_back(int(stencils.items.size()));
  }
  return stencils;
}

CGAL_GDP_INLINE Eigen::SparseMatrix<double> modified_dirichlet(const Indexed_triangles& mesh,
                                                               const Triangle_metrics& metrics,
                                                               const std::vector<Vec3>& normals, bool parallel)
{
  Element_matrices elements(triangle_stencils(mesh));
  parallel_for(parallel, mesh.triangles.size(), [&](std::size_t f) {
    const int e = int(f);
    const auto& t = mesh.triangles[f];
    const Triangle_metric metric = metrics(mesh, e);
    for(int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const double of_i = half_cotangent(metric, i), of_j = half_cotangent(metric, j), of_k = half_cotangent(metric, k);
      elements.value(e, j, k) =
        -of_i * normals[std::size_t(t[std::size_t(j)])].dot(normals[std::size_t(t[std::size_t(k)])]);
      elements.value(e, i, i) = (of_j + of_k) * normals[std::size_t(t[std::size_t(i)])].squaredNorm();
    }
  });
  return elements.sum(mesh.number_of_vertices(), parallel);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_MODIFIED_DIRICHLET_IMPL_H
