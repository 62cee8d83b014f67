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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_READ_PARAMETERS_IMPL_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_READ_PARAMETERS_IMPL_H

#include <CGAL/Gradient_domain_processing/internal/filtering/read_parameters.h>
#include <CGAL/Gradient_domain_processing/internal/separate_compilation.h>

#include <algorithm>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

CGAL_GDP_INLINE std::vector<double> unless_constant(std::vector<double> numbers, double& same)
{
  if(numbers.empty() || !std::equal(numbers.begin() + 1, numbers.end(), numbers.begin()))
    return numbers;
  same = numbers.front();
  return {};
}

CGAL_GDP_INLINE std::vector<double> at_vertices(const Indexed_triangles& mesh, std::vector<double> at_rows)
{
  if(mesh.vertex_of_row.empty() && mesh.virtual_vertices.size() == 0)
    return at_rows;
  for(int k = 0; k < mesh.virtual_vertices.size(); ++k)
  {
    double sum = 0;
    for(const int* row = mesh.virtual_vertices.corners.begin(k); row != mesh.virtual_vertices.corners.end(k); ++row)
      sum += at_rows[*row];
    at_rows.push_back(sum / mesh.virtual_vertices.corners.size(k));
  }
  std::vector<double> sums(mesh.points.size(), 0.);
  std::vector<int> counts(mesh.points.size(), 0);
  for(int row = 0; row < mesh.number_of_rows(); ++row)
  {
    sums[mesh.vertex_of(row)] += at_rows[row];
    ++counts[mesh.vertex_of(row)];
  }
  for(std::size_t v = 0; v < sums.size(); ++v)
    sums[v] /= counts[v];
  return sums;
}

CGAL_GDP_INLINE std::vector<double> at_triangles(const Indexed_triangles& mesh, std::vector<double> at_faces)
{
  if(mesh.face_of_triangle.empty())
    return at_faces;
  std::vector<double> numbers;
  for(int face : mesh.face_of_triangle)
    numbers.push_back(at_faces[face]);
  return numbers;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_READ_PARAMETERS_IMPL_H
