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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_PARALLEL_NUMBER_OF_THREADS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_PARALLEL_NUMBER_OF_THREADS_H

#include <algorithm>
#include <thread>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// How many there may be, for estimates.
inline unsigned number_of_threads(bool parallel)
{
#ifdef CGAL_LINKED_WITH_TBB
  return parallel ? (std::max)(std::thread::hardware_concurrency(), 1u) : 1;
#else
  (void)parallel;
  return 1;
#endif
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_PARALLEL_NUMBER_OF_THREADS_H
