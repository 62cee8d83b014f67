// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_TBB_PARALLEL_FOR_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_TBB_PARALLEL_FOR_H

#ifdef CGAL_LINKED_WITH_TBB

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <utility>

#if defined(__SANITIZE_THREAD__)
#define CGAL_GRADIENT_DOMAIN_PROCESSING_THREAD_SANITIZER
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define CGAL_GRADIENT_DOMAIN_PROCESSING_THREAD_SANITIZER
#endif
#endif

#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_THREAD_SANITIZER

// ThreadSanitizer does not see into the library of TBB, which is compiled without it, and would not know that the parts of a
// loop come after all that was before the loop. It is told by two addresses: where the loop began, and where a part ended.
template <class Range, class Body>
struct Body_between_fork_and_join
{
  const Body* body;
  char* fork;
  char* join;

  __attribute__((no_sanitize("thread"))) void operator()(const Range& range) const
  {
    __tsan_acquire(fork);
    (*body)(range);
    __tsan_release(join);
  }
};

template <class Range, class Body, class... Arguments>
void tbb_parallel_for(const Range& range, const Body& body, Arguments&&... arguments)
{
  char fork, join;
  __tsan_release(&fork);
  tbb::parallel_for(range, Body_between_fork_and_join<Range, Body>{&body, &fork, &join}, std::forward<Arguments>(arguments)...);
  __tsan_acquire(&join);
}

#else

template <class Range, class Body, class... Arguments>
void tbb_parallel_for(const Range& range, const Body& body, Arguments&&... arguments)
{
  tbb::parallel_for(range, body, std::forward<Arguments>(arguments)...);
}

#endif

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_LINKED_WITH_TBB

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_TBB_PARALLEL_FOR_H
