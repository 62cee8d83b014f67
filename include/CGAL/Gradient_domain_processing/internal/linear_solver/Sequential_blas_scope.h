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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_SEQUENTIAL_BLAS_SCOPE_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_SEQUENTIAL_BLAS_SCOPE_H

#include <CGAL/Gradient_domain_processing/internal/linear_solver/Borrowed_number.h>

#if defined(__unix__) || defined(__APPLE__)
#include <dlfcn.h>
#define CGAL_GRADIENT_DOMAIN_PROCESSING_HAS_DLSYM
#endif

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// While it lives, CHOLMOD works on one thread. The fronts of a surface are small: CHOLMOD asks OpenMP for four threads
// at each of them and OpenBLAS for as many as there are processors, which costs more than it saves on an idle machine,
// and many times the work on a busy one. Whether there are an OpenMP and an OpenBLAS in the process is known when it
// runs.
class Sequential_blas_scope
{
public:
  Sequential_blas_scope()
  {
    openmp_threads().enter(); // an OpenBLAS that is made with OpenMP changes them
    openmp_levels().enter();
    openblas_threads().enter();
  }
  ~Sequential_blas_scope()
  {
    openblas_threads().leave();
    openmp_levels().leave();
    openmp_threads().leave();
  }
  Sequential_blas_scope(const Sequential_blas_scope&) = delete;
  Sequential_blas_scope& operator=(const Sequential_blas_scope&) = delete;

private:
  static Borrowed_number& openmp_threads()
  {
    static Borrowed_number threads(getter("omp_get_max_threads"), setter("omp_set_num_threads"), 1);
    return threads;
  }
  static Borrowed_number& openmp_levels()
  {
    static Borrowed_number levels(getter("omp_get_max_active_levels"), setter("omp_set_max_active_levels"), 0);
    return levels;
  }
  static Borrowed_number& openblas_threads()
  {
    static Borrowed_number threads(getter("openblas_get_num_threads"), setter("openblas_set_num_threads"), 1);
    return threads;
  }

  // null where the library is not there
  static Borrowed_number::Getter getter(const char* name) { return function<Borrowed_number::Getter>(name); }
  static Borrowed_number::Setter setter(const char* name) { return function<Borrowed_number::Setter>(name); }

  template <class Function>
  static Function function(const char* name)
  {
#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_HAS_DLSYM
    return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
#else
    (void)name;
    return nullptr;
#endif
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#undef CGAL_GRADIENT_DOMAIN_PROCESSING_HAS_DLSYM

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_SEQUENTIAL_BLAS_SCOPE_H
