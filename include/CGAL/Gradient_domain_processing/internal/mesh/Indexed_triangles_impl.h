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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_INDEXED_TRIANGLES_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_INDEXED_TRIANGLES_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_blocks.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_for.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE double Indexed_triangles::area(bool parallel) const
{
  return sum_over_blocks(parallel, triangles.size(), 4096, 0., [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for(std::size_t f = begin; f < end; ++f)
      sum += embedding_metric(int(f)).with_area_bounded_below(degeneracy_ratio).area();
    return sum;
  });
}

CGAL_GDP_INLINE void Indexed_triangles::index_corners(bool parallel)
{
  corners = numbers_by_key(parallel, number_of_vertices(), 3 * triangles.size(),
                           [&](std::size_t corner) { return triangles[corner / 3][corner % 3]; });
}

CGAL_GDP_INLINE Lists Indexed_triangles::one_rings(bool parallel) const
{
  const int n = number_of_vertices();
  Lists rings;
  rings.offsets.assign(n + 1, 0);
  std::vector<int> found(2 * corners.items.size());
  parallel_for(parallel, n, [&](std::size_t v) {
    int* const first = found.data() + 2 * std::size_t(corners.offsets[v]);
    int* last = first;
    for(const int* c = corners.begin(int(v)); c != corners.end(int(v)); ++c)
      for(int w : opposite_vertices(*c))
      {
        const int* at = first;
        while(at != last && *at != w)
          ++at;
        if(at == last && w != int(v))
          *last++ = w;
      }
    rings.offsets[v + 1] = int(last - first);
  });
  for(int v = 0; v < n; ++v)
    rings.offsets[v + 1] += rings.offsets[v];
  rings.items.resize(rings.offsets[n]);
  parallel_for(parallel, n, [&](std::size_t v) {
    const int* const first = found.data() + 2 * std::size_t(corners.offsets[v]);
    std::copy(first, first + rings.size(int(v)), rings.items.begin() + rings.offsets[v]);
  });
  return rings;
}

CGAL_GDP_INLINE std::vector<Vec3> Indexed_triangles::vertex_normals(const std::vector<Vec3>& at, bool parallel) const
{
  std::vector<Vec3> normals(at.size());
  parallel_for(parallel, at.size(), [&](std::size_t v) {
    Vec3 sum(0, 0, 0);
    for(const int* c = corners.begin(int(v)); c != corners.end(int(v)); ++c)
      sum += area_vector(*c / 3, at);
    const double length = sum.norm();
    normals[v] = length > 0 ? Vec3(sum / length) : Vec3(0, 0, 0);
  });
  return normals;
}

CGAL_GDP_INLINE std::vector<Vec3> as_vectors(const Signal& signal)
{
  std::vector<Vec3> vectors(std::size_t(signal.rows()));
  for(std::size_t v = 0; v < vectors.size(); ++v)
    vectors[v] = signal.row(Eigen::Index(v)).transpose();
  return vectors;
}

CGAL_GDP_INLINE Signal as_signal(const std::vector<Vec3>& vectors)
{
  return Eigen::Map<const Signal>(vectors.empty() ? nullptr : vectors[0].data(), Eigen::Index(vectors.size()), 3);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_INDEXED_TRIANGLES_IMPL_H
