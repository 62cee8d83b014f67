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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_MORTON_ORDER_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_MORTON_ORDER_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/mesh/Lists.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/morton_order.h>
#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_for.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Puts two zeros before each of the lowest ten bits.
CGAL_GDP_INLINE std::uint32_t spread_bits(std::uint32_t x)
{
  x = (x | x << 16) & 0x030000FF;
  x = (x | x << 8) & 0x0300F00F;
  x = (x | x << 4) & 0x030C30C3;
  return (x | x << 2) & 0x09249249;
}

CGAL_GDP_INLINE std::vector<std::uint32_t> morton_keys(const std::vector<Eigen::Vector3d>& points, bool parallel)
{
  constexpr int cells_per_axis = 1024;
  Eigen::AlignedBox3d box;
  for(const Eigen::Vector3d& p : points)
    box.extend(p);
  const double extent = points.empty() ? 0. : box.sizes().maxCoeff();
  const double scale = extent > 0 ? (cells_per_axis - 1) / extent : 0.;

  std::vector<std::uint32_t> keys(points.size());
  parallel_for(parallel, points.size(), [&](std::size_t i) {
    const Eigen::Matrix<std::uint32_t, 3, 1> cell = ((points[i] - box.min()) * scale).cast<std::uint32_t>();
    keys[i] = spread_bits(cell.x()) | spread_bits(cell.y()) << 1 | spread_bits(cell.z()) << 2;
  });
  return keys;
}

// By the lower half of the bits, then by the upper.
CGAL_GDP_INLINE std::vector<int> morton_order(const std::vector<Eigen::Vector3d>& points, bool parallel)
{
  constexpr int radix = 1 << 15;
  const std::vector<std::uint32_t> keys = morton_keys(points, parallel);
  const std::vector<int> by_lower =
    numbers_by_key(parallel, radix, keys.size(), [&](std::size_t i) { return int(keys[i] % radix); }).items;
  std::vector<int> order = numbers_by_key(parallel, radix, keys.size(), [&](std::size_t i) {
    return int(keys[std::size_t(by_lower[i])] / radix);
  }).items;
  parallel_for(parallel, order.size(), [&](std::size_t i) { order[i] = by_lower[std::size_t(order[i])]; });
  return order;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_MORTON_ORDER_IMPL_H
