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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_POSITIONS_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_POSITIONS_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/filtering/filter_positions.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE Error_code smooth_without_shrinking(Filter& filter, int order)
{
  Signal missing = as_signal(filter.mesh().points), change;
  for(int i = 0; i < order; ++i)
  {
    if(const Error_code code = filter.solve_by_vertex(missing, change))
      return code;
    missing = -change;
  }
  filter.move_points(-missing);
  return ok;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FILTER_POSITIONS_IMPL_H
