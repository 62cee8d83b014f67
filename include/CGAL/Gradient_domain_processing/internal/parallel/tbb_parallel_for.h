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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_PARALLEL_TBB_PARALLEL_FOR_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_PARALLEL_TBB_PARALLEL_FOR_H

#ifdef CGAL_LINKED_WITH_TBB

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>
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
#define CGAL_GRADIENT_DOMAIN_PROCESSING_NO_TSAN __attribute__((no_sanitize("thread")))
#else
#define CGAL_GRADIENT_DOMAIN_PROCESSING_NO_TSAN
#endif

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

typedef tbb::blocked_range<std::size_t> Loop_range;

// A reference to the body of a loop, of one type for all loops: TBB's templates are instantiated once instead of for
// every body, and their names stay short enough for ThreadSanitizer to find those it shall suppress.
class Loop_body
{
public:
  template <class Body>
  static Loop_body of(const Body& body)
  {
    return Loop_body(&body, [](const void* erased, const Loop_range& range) CGAL_GRADIENT_DOMAIN_PROCESSING_NO_TSAN {
      (*static_cast<const Body*>(erased))(range);
    });
  }

  CGAL_GRADIENT_DOMAIN_PROCESSING_NO_TSAN void operator()(const Loop_range& range) const { m_call(m_body, range); }

private:
  typedef void (*Call)(const void* body, const Loop_range& range);

  Loop_body(const void* body, Call call) : m_body(body), m_call(call) {}

  const void* m_body;
  Call m_call;
};

// ThreadSanitizer does not see into the library of TBB, which is compiled without it, and would not know that the parts
// of a loop come after all that was before the loop. It is told by two addresses: where the loop began, and where a
// part ended.
template <class Body, class... Arguments>
void tbb_parallel_for(const Loop_range& range, const Body& body, Arguments&&... arguments)
{
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_THREAD_SANITIZER
  char fork, join;
  const auto body_between = [&](const Loop_range& part) CGAL_GRADIENT_DOMAIN_PROCESSING_NO_TSAN {
    __tsan_acquire(&fork);
    body(part);
    __tsan_release(&join);
  };
  __tsan_release(&fork);
  tbb::parallel_for(range, Loop_body::of(body_between), std::forward<Arguments>(arguments)...);
  __tsan_acquire(&join);
#else
  tbb::parallel_for(range, Loop_body::of(body), std::forward<Arguments>(arguments)...);
#endif
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_LINKED_WITH_TBB

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_PARALLEL_TBB_PARALLEL_FOR_H
