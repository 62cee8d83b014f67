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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_CHOSEN_REGION_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_CHOSEN_REGION_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Which of the faces that were read are in a region. False where one of the region was not read.
template <class FaceRange, class Face>
bool find_faces(const FaceRange& region, const std::vector<Face>& faces, std::vector<char>& is_inside)
{
  std::vector<std::size_t> order(faces.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return faces[i] < faces[j]; });
  is_inside.assign(faces.size(), 0);
  for(const auto& f : region)
  {
    const Face face = Face(f);
    const auto found = std::lower_bound(order.begin(), order.end(), face,
                                        [&](std::size_t i, const Face& other) { return faces[i] < other; });
    if(found == order.end() || face < faces[*found])
      return false;
    is_inside[*found] = 1;
  }
  return true;
}

// The vertices with a face outside of a region, beside those that have one outside of what was read.
template <class FaceRange, class Face>
Error_code choose_region(const FaceRange& region, const std::vector<Face>& faces, const Indexed_triangles& mesh,
                         std::vector<char>& has_face_outside)
{
  std::vector<char> is_inside;
  if(!find_faces(region, faces, is_inside))
    return error_invalid_region;
  has_face_outside.resize(mesh.points.size(), 0);
  for(int v = 0; v < mesh.first_virtual_vertex(); ++v)
    for(const int* corner = mesh.corners.begin(v); corner != mesh.corners.end(v); ++corner)
      if(!is_inside[std::size_t(mesh.face_of(*corner / 3))])
        has_face_outside[std::size_t(v)] = 1;
  return ok;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_CHOSEN_REGION_H
