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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_WRITE_BACK_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_WRITE_BACK_H

#include <CGAL/Gradient_domain_processing/internal/filtering/Filter.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/signals.h>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The last stage: a result goes to the caller's map. Values of vertices that are not moved are copied from `in`, to the
// bit.
template <class InMap, class OutMap, class Surface, class Is_moved>
Error_code write_back(InMap in, const Signal& signal, OutMap out, const Surface_elements<Surface>& elements,
                      Filter& filter, const Is_moved& is_moved)
{
  if(const Error_code code = filter.ready())
    return code;
  Stage_scope stage(filter.progress(), Stage::WRITE);
  return write_signal(in, signal, out, elements, filter.mesh(), is_moved, filter.culprit);
}

template <class InMap, class OutMap, class Surface>
Error_code write_back(InMap in, const Signal& signal, OutMap out, const Surface_elements<Surface>& elements,
                      Filter& filter)
{
  return write_back(in, signal, out, elements, filter, [&](int v) { return filter.is_moved(v); });
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_WRITE_BACK_H
