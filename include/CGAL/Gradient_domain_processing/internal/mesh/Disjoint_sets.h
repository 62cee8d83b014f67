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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_DISJOINT_SETS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_DISJOINT_SETS_H

#include <boost/pending/disjoint_sets.hpp>

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Sets of numbers below n, by Boost's union-find.
class Disjoint_sets
{
  std::vector<int> m_rank, m_parent;
  boost::disjoint_sets<int*, int*> m_sets;

public:
  explicit Disjoint_sets(int n) : m_rank(n), m_parent(n), m_sets(m_rank.data(), m_parent.data())
  {
    for(int i = 0; i < n; ++i)
      m_sets.make_set(i);
  }
  Disjoint_sets(const Disjoint_sets&) = delete;
  Disjoint_sets& operator=(const Disjoint_sets&) = delete;

  int root(int i) { return m_sets.find_set(i); }
  void join(int i, int j) { m_sets.union_set(i, j); }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_DISJOINT_SETS_H
