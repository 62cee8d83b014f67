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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_CHOLMOD_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_CHOLMOD_H

#ifdef CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD

#include <CGAL/Gradient_domain_processing/internal/linear_solver/Eigen_solver_handling.h>
#include <CGAL/Gradient_domain_processing/internal/linear_solver/Sequential_blas_scope.h>

#include <Eigen/CholmodSupport>

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Settings of CHOLMOD that suit the systems of this package, for as long as it lives. What the caller has set stays as
// it is.
class Cholmod_settings_scope
{
  cholmod_common& m_common;
  const int m_print, m_nmethods, m_ordering, m_postorder;
  std::size_t m_nrelax[3];
#if CHOLMOD_MAIN_VERSION >= 4
  const int m_nthreads_max;
#endif

public:
  Cholmod_settings_scope(cholmod_common& common, bool merges_small_fronts)
    : m_common(common)
    , m_print(common.print)
    , m_nmethods(common.nmethods)
    , m_ordering(common.method[0].ordering)
    , m_postorder(common.postorder)
#if CHOLMOD_MAIN_VERSION >= 4
    , m_nthreads_max(common.nthreads_max)
#endif
  {
    std::copy(std::begin(common.nrelax), std::end(common.nrelax), m_nrelax);
#if CHOLMOD_MAIN_VERSION >= 4
    common.nthreads_max = 1;
#endif
    if(common.print == 3) // its default: warnings on the terminal
      common.print = 0;
    if(common.nmethods == 0)
      keep_order();
    if(merges_small_fronts)
      merge_small_fronts();
  }

  ~Cholmod_settings_scope()
  {
    m_common.print = m_print;
    m_common.nmethods = m_nmethods;
    m_common.method[0].ordering = m_ordering;
    m_common.postorder = m_postorder;
    std::copy(std::begin(m_nrelax), std::end(m_nrelax), m_common.nrelax);
#if CHOLMOD_MAIN_VERSION >= 4
    m_common.nthreads_max = m_nthreads_max;
#endif
  }

  Cholmod_settings_scope(const Cholmod_settings_scope&) = delete;
  Cholmod_settings_scope& operator=(const Cholmod_settings_scope&) = delete;

private:
  // The degrees of freedom come in a fill-reducing order already, postordered: CHOLMOD shall not look for another, nor
  // copy the matrix to permute it.
  void keep_order()
  {
    m_common.nmethods = 1;
    m_common.method[0].ordering = CHOLMOD_NATURAL;
    m_common.postorder = 0;
  }

  // Fewer and larger fronts, with some zeros in them: a third of the time where they are tiny, as in a graph of degree
  // three, for a factor that is larger by as much.
  void merge_small_fronts()
  {
    std::size_t (&columns)[3] = m_common.nrelax;
    if(columns[0] == 4 && columns[1] == 16 && columns[2] == 48) // its defaults
    {
      columns[0] = 12;
      columns[1] = 32;
      columns[2] = 64;
    }
  }
};

template <int options, class Index, int triangle>
struct Eigen_solver_handling<Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double, options, Index>, triangle> >
{
  typedef Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double, options, Index>, triangle> Solver;

  static constexpr bool reads_lower_triangle = triangle == Eigen::Lower;

  struct Work_scope
  {
    Cholmod_settings_scope settings;
    Sequential_blas_scope threads;
    Work_scope(Solver& solver, bool merges_small_fronts) : settings(solver.cholmod(), merges_small_fronts) {}
  };

  static bool has_failed(Solver& solver) { return solver.cholmod().status < 0; }

  static void release_workspace(Solver& solver)
  {
    if(sizeof(Index) == sizeof(int))
      cholmod_free_work(&solver.cholmod());
    else
      cholmod_l_free_work(&solver.cholmod());
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_CHOLMOD_H
