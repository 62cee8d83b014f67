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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_PREPARE_FILTER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_PREPARE_FILTER_H

#include <CGAL/Gradient_domain_processing/internal/filtering/read_parameters.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/point_map.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/read_graph.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/read_soup.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// What a surface that was read, with this code, is filtered with: the unit of weights, constraints and weights.
template <class Surface, class NamedParameters>
Error_code prepare_filter(const Surface& surface, const NamedParameters& np, const Reading& reading, Error_code code,
                          const Surface_elements<Surface>& elements, const std::vector<char>& has_face_outside,
                          Filter& filter)
{
  filter.culprit = reading.culprit;
  filter.system.parallel = reading.parallel;
  if(code != ok)
    return code;
  const Indexed_triangles& mesh = filter.mesh();
  filter.squared_length_unit = parameter(np, CGAL::internal_np::area_normalization, true)
    ? total_area(surface, point_map(surface, np), elements, mesh, filter.system.parallel)
    : 1 / (mesh.unit() * mesh.unit());
  if(!std::isfinite(filter.squared_length_unit))
    return error_invalid_point;
  read_constraints(np, elements, has_face_outside, filter);
  return read_weights(np, elements, filter);
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_FILTERING_PREPARE_FILTER_H
