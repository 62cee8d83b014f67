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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_ESTIMATES_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_ESTIMATES_H

#include <CGAL/Gradient_domain_processing/internal/curvature/Principal_curvatures.h>

#include <functional>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// At the vertices, by jets. A template, as what is made of it, so that only programs that fit jets compile them. False:
// cancelled.
template <class Void = void>
bool vertex_curvatures_by_jets(const Indexed_triangles& mesh, const std::vector<Vec3>& points,
                               const std::vector<Vec3>& normals, int jet_degree, bool parallel,
                               const std::function<bool(double)>& go_on, std::vector<Principal_curvatures>& curvatures);

// At the triangles, as the mean of the tensors at the corners.
std::vector<Principal_curvatures> triangle_curvatures(const Indexed_triangles& mesh, bool parallel,
                                                      const std::vector<Principal_curvatures>& at_vertices);

// At the triangles, from normals at the vertices, which are normalized.
std::vector<Principal_curvatures> triangle_curvatures_by_normals(const Indexed_triangles& mesh, bool parallel,
                                                                 std::vector<Vec3> normals);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/curvature/estimates_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_ESTIMATES_H
