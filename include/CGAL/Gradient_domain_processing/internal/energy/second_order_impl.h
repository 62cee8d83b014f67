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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_SECOND_ORDER_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_SECOND_ORDER_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/energy/second_order.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE Lists second_rings(const Lists& rings)
{
  Lists result;
  result.offsets.push_back(0);
  for(int v = 0; v < rings.size(); ++v)
  {
    const std::size_t begin = result.items.size();
    result.items.insert(result.items.end(), rings.begin(v), rings.end(v));
    for(const int* w = rings.begin(v); w != rings.end(v); ++w)
      result.items.insert(result.items.end(), rings.begin(*w), rings.end(*w));
    std::sort(result.items.begin() + begin, result.items.end());
    result.items.erase(std::unique(result.items.begin() + begin, result.items.end()), result.items.end());
    result.items.erase(std::remove(result.items.begin() + begin, result.items.end(), v), result.items.end());
    result.offsets.push_back(int(result.items.size()));
  }
  return result;
}

CGAL_GDP_INLINE Sparse_matrix restricted(const Sparse_matrix& matrix, const Degrees_of_freedom& dofs)
{
  std::vector<Eigen::Triplet<double> > entries;
  entries.reserve(std::size_t(matrix.nonZeros()));
  for(int v = 0; v < int(matrix.cols()); ++v)
    if(dofs.of_vertex[std::size_t(v)] >= 0)
      for(Sparse_matrix::InnerIterator it(matrix, v); it; ++it)
        if(dofs.of_vertex[std::size_t(it.row())] >= 0)
          entries.emplace_back(dofs.of_vertex[std::size_t(it.row())], dofs.of_vertex[std::size_t(v)], it.value());
  Sparse_matrix result(dofs.size(), dofs.size());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_SECOND_ORDER_IMPL_H
