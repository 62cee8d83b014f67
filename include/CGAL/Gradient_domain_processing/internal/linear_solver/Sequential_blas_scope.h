// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_SEQUENTIAL_BLAS_SCOPE_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_SEQUENTIAL_BLAS_SCOPE_H

#if defined(__unix__) || defined(__APPLE__)
#include <dlfcn.h>
#define CGAL_GRADIENT_DOMAIN_PROCESSING_HAS_DLSYM
#endif

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// While it lives, CHOLMOD works on one thread. The fronts of a surface are small: CHOLMOD asks OpenMP for four threads at each of
// them and OpenBLAS for as many as there are processors, which costs more than it saves on an idle machine, and many times
// the work on a busy one. Whether there are an OpenMP and an OpenBLAS in the process is known when it runs.
class Sequential_blas_scope
{
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_HAS_DLSYM
  struct Number
  {
    int (*get)();
    void (*set)(int);

    Number(const char* getter, const char* setter)
      : get(reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, getter)))
      , set(reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, setter)))
    {}

    // returns the number before
    int exchange(int number) const
    {
      if(!get || !set)
        return number;
      const int before = get();
      set(number);
      return before;
    }
  };

  static const Number& openmp_levels()
  {
    static const Number levels("omp_get_max_active_levels", "omp_set_max_active_levels");
    return levels;
  }
  static const Number& openblas_threads()
  {
    static const Number threads("openblas_get_num_threads", "openblas_set_num_threads");
    return threads;
  }

  const int m_levels = openmp_levels().exchange(0), m_threads = openblas_threads().exchange(1);

public:
  Sequential_blas_scope() {}
  Sequential_blas_scope(const Sequential_blas_scope&) = delete;
  Sequential_blas_scope& operator=(const Sequential_blas_scope&) = delete;
  ~Sequential_blas_scope()
  {
    openblas_threads().exchange(m_threads);
    openmp_levels().exchange(m_levels);
  }
#endif
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#undef CGAL_GRADIENT_DOMAIN_PROCESSING_HAS_DLSYM

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_SEQUENTIAL_BLAS_SCOPE_H
