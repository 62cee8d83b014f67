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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_PARALLEL_PARALLEL_FOR_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_PARALLEL_PARALLEL_FOR_H

#include <CGAL/Gradient_domain_processing/internal/parallel/tbb_parallel_for.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Calls body(i) for i in [0, n). Every body writes only what belongs to i, so that the order does not matter and the
// result is the same to the bit with any number of threads.
template <class Body>
void parallel_for(bool parallel, std::size_t n, const Body& body)
{
#ifdef CGAL_LINKED_WITH_TBB
  const std::size_t grain = 2048; // below it, a task costs more than it saves
  if(parallel && n > grain)
  {
    tbb_parallel_for(Loop_range(0, n, grain), [&](const Loop_range& range) {
      for(std::size_t i = range.begin(); i != range.end(); ++i)
        body(i);
    });
    return;
  }
#else
  (void)parallel;
#endif
  for(std::size_t i = 0; i < n; ++i)
    body(i);
}

template <class ConcurrencyTag>
constexpr bool is_parallel()
{
  return !std::is_same<ConcurrencyTag, Sequential_tag>::value;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_PARALLEL_PARALLEL_FOR_H
