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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_BILAPLACIAN_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_BILAPLACIAN_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/higher_order/bilaplacian.h>
#include <CGAL/Gradient_domain_processing/internal/energy/element_matrices.h>
#include <CGAL/Gradient_domain_processing/internal/higher_order/Element_matrices.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_for.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE std::vector<double> lumped_masses(const Indexed_triangles& mesh, const Triangle_metrics& metrics,
                                                  bool parallel)
{
  std::vector<double> masses(mesh.points.size());
  parallel_for(parallel, masses.size(), [&](std::size_t v) {
    double sum = 0;
    for(const int* c = mesh.corners.begin(int(v)); c != mesh.corners.end(int(v)); ++c)
      sum += metrics(mesh, *c / 3).area();
    masses[v] = sum / 3;
  });
  return masses;
}

CGAL_GDP_INLINE Eigen::SparseMatrix<double> bilaplacian(const Indexed_triangles& mesh, const Triangle_metrics& metrics,
                                                        bool parallel)
{
  const std::size_t n = mesh.points.size();
  const Lists rings = mesh.one_rings(parallel);
  Lists stencils; // every vertex and its ring
  stencils.offsets.assign(1, 0);
  stencils.items.reserve(rings.items.size() + n);
  for(int v = 0; v < int(n); ++v)
  {
    stencils.items.push_back(v);
    stencils.items.insert(stencils.items.end(), rings.begin(v), rings.end(v));
    stencils.offsets.push_back(int(stencils.items.size()));
  }

  Element_matrices elements(std::move(stencils));
  parallel_for(parallel, n, [&](std::size_t i) {
    const int v = int(i), size = elements.size(v);
    const int* const stencil = elements.indices(v);
    std::vector<double> row(std::size_t(size), 0.);
    double mass = 0;
    const auto add = [&](int w, double value) {
      row[std::size_t(std::find(stencil, stencil + size, w) - stencil)] -= value;
      row[0] += value;
    };
    for(const int* c = mesh.corners.begin(v); c != mesh.corners.end(v); ++c)
    {
      const Triangle_metric metric = metrics(mesh, *c / 3);
      const auto others = mesh.opposite_vertices(*c);
      add(others[0], half_cotangent(metric, (*c % 3 + 2) % 3));
      add(others[1], half_cotangent(metric, (*c % 3 + 1) % 3));
      mass += metric.area() / 3;
    }
    elements.set_rank_one(v, mass > 0 ? 1 / mass : 0, row.data());
  });
  return elements.sum(int(n), parallel);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_HIGHER_ORDER_BILAPLACIAN_IMPL_H
