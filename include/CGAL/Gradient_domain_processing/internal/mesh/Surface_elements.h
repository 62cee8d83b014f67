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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_SURFACE_ELEMENTS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_SURFACE_ELEMENTS_H

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// A soup as one type, so that it can stand where a mesh stands. Its vertices and faces are the indices of points and
// polygons.
template <class PointRange, class PolygonRange>
struct Polygon_soup
{
  PointRange& points; // may be const
  const PolygonRange& polygons;
};

template <class Surface>
struct Surface_traits
{
  typedef typename boost::graph_traits<Surface>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Surface>::face_descriptor face_descriptor;
};

template <class PointRange, class PolygonRange>
struct Surface_traits<Polygon_soup<PointRange, PolygonRange> >
{
  typedef std::size_t vertex_descriptor;
  typedef std::size_t face_descriptor;
};

// What is behind the rows and faces of the arrays.
template <class Surface>
struct Surface_elements
{
  std::vector<typename Surface_traits<Surface>::vertex_descriptor> vertices;
  std::vector<typename Surface_traits<Surface>::face_descriptor> faces;
};

// The first element that an error is about, or none.
struct Culprit
{
  int row = -1, face = -1;
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_SURFACE_ELEMENTS_H
