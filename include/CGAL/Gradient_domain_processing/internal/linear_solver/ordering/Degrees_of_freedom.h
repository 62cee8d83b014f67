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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_DEGREES_OF_FREEDOM_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_DEGREES_OF_FREEDOM_H

#include <CGAL/Gradient_domain_processing/internal/parallel/parallel_for.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Which vertices are solved for, and in which order: that of the rows and columns of the matrix.
struct Degrees_of_freedom
{
  std::vector<int> of_vertex; // the degree of freedom of every vertex, or -1
  std::vector<int> vertex;    // the vertex of every degree of freedom

  int size() const { return static_cast<int>(vertex.size()); }
};

// The vertices listed in `order` become the degrees of freedom 0, 1, ...
inline Degrees_of_freedom numbered(std::vector<int> order, std::size_t number_of_vertices)
{
  Degrees_of_freedom result;
  result.vertex.swap(order);
  result.of_vertex.assign(number_of_vertices, -1);
  for(int i = 0; i < result.size(); ++i)
    result.of_vertex[std::size_t(result.vertex[std::size_t(i)])] = i;
  return result;
}

// In the order of the vertices: what a solver that eliminates nothing wants, for that order is local in memory.
inline Degrees_of_freedom numbered_in_memory_order(const std::vector<char>& is_solved_for)
{
  std::vector<int> order;
  order.reserve(is_solved_for.size());
  for(std::size_t v = 0; v < is_solved_for.size(); ++v)
    if(is_solved_for[v])
      order.push_back(int(v));
  return numbered(std::move(order), is_solved_for.size());
}

// body(v, i) for every vertex v and its degree of freedom i, in the order of the vertices: the arrays of the mesh are
// local in memory in that order, in the order of elimination less so.
template <class Body>
void for_each_degree_of_freedom(bool parallel, const Degrees_of_freedom& degrees_of_freedom, const Body& body)
{
  parallel_for(parallel, degrees_of_freedom.of_vertex.size(), [&](std::size_t v) {
    if(degrees_of_freedom.of_vertex[v] >= 0)
      body(int(v), degrees_of_freedom.of_vertex[v]);
  });
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_LINEAR_SOLVER_ORDERING_DEGREES_OF_FREEDOM_H
