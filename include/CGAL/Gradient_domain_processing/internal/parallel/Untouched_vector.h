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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_PARALLEL_UNTOUCHED_VECTOR_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_PARALLEL_UNTOUCHED_VECTOR_H

#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Leaves new elements as the memory is, where no value is given.
template <class T>
struct Untouched_allocator : std::allocator<T>
{
  template <class U>
  struct rebind { typedef Untouched_allocator<U> other; };

  Untouched_allocator() = default;
  template <class U>
  Untouched_allocator(const Untouched_allocator<U>&) {}

  void construct(T*) { static_assert(std::is_trivially_copyable<T>::value, ""); }
  template <class... Arguments>
  void construct(T* at, Arguments&&... arguments)
  {
    ::new(static_cast<void*>(at)) T(std::forward<Arguments>(arguments)...);
  }
};

// For a parallel loop that writes every element: the first touch of memory, which costs more than the writing, is
// parallel then.
template <class T>
using Untouched_vector = std::vector<T, Untouched_allocator<T> >;

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_PARALLEL_UNTOUCHED_VECTOR_H
