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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FACE_ENERGY_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FACE_ENERGY_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/visitor.h>
#include <CGAL/Gradient_domain_processing/internal/denoising/Dual_graph.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Equation 1 of the paper on polygons that share an edge with no third one. What both say of their edge is the same.
struct Face_energy
{
  struct Neighbor
  {
    int face;
    double weight; // beta times the weight of the edge, at least 0
  };
  std::vector<double> values;      // alpha times the area of every face, positive
  std::vector<double> scales;      // lambda of every face; an edge gets the mean of its two
  std::vector<int> first_neighbor; // of every face, and the end
  std::vector<Neighbor> neighbors;
  std::vector<double> inverse_diagonal;

  int size() const { return int(values.size()); }

  // visit(neighbor) in the order of the edges.
  template <class Visit>
  void for_each_neighbor(int f, const Visit& visit) const
  {
    for(int i = first_neighbor[f]; i < first_neighbor[f + 1]; ++i)
      visit(neighbors[i]);
  }
};

// (A + L) g = (A + lambda L) f for every column of `signal`, a row a face; solved for the change, so that nothing
// changes where lambda is 1.
Error_code filter_face_signal(const Face_energy& energy, bool parallel, Progress& progress, Signal& signal);

// Where the areas of the faces have their centers; the mean of their triangles' where they have none.
std::vector<Vec3> face_centers(const Indexed_triangles& mesh, std::size_t number_of_faces);

// The length of an edge divided by the distance of the centers of its faces.
double default_edge_weight(const Vec3& v, const Vec3& w, const Vec3& center, const Vec3& other_center);

// The edge i of triangle f as the first of its two triangles has it, from row to row.
std::array<int, 2> edge_of_lower(const Indexed_triangles& mesh, int f, int i, int g);

// Sets first_neighbor and makes room.
void count_neighbors(const Indexed_triangles& mesh, const Dual_graph& dual, Face_energy& energy);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/filtering/face_energy_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_FACE_ENERGY_H
