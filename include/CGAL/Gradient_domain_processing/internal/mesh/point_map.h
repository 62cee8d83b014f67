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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_POINT_MAP_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_POINT_MAP_H

#include <CGAL/Gradient_domain_processing/parameters.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Surface_elements.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// The points of a soup as a property map.
template <class PointRange>
struct Range_map
{
  typedef std::size_t key_type;
  typedef typename std::decay<decltype(std::declval<PointRange&>()[0])>::type value_type;
  typedef const value_type& reference;
  typedef boost::read_write_property_map_tag category;

  PointRange* range;

  friend const value_type& get(const Range_map& map, std::size_t i) { return (*map.range)[i]; }
  friend void put(const Range_map& map, std::size_t i, const value_type& value) { (*map.range)[i] = value; }
};

template <class Graph, class NamedParameters>
auto point_map(const Graph& graph, const NamedParameters& np)
{
  return parameter(np, CGAL::internal_np::vertex_point, get_const_property_map(CGAL::vertex_point, graph));
}

template <class Graph, class NamedParameters>
auto writable_point_map(Graph& graph, const NamedParameters& np)
{
  return parameter(np, CGAL::internal_np::vertex_point, get_property_map(CGAL::vertex_point, graph));
}

template <class PointRange, class PolygonRange, class NamedParameters>
Range_map<PointRange> point_map(const Polygon_soup<PointRange, PolygonRange>& soup, const NamedParameters&)
{
  return {&soup.points};
}

template <class PointRange>
Range_map<PointRange> writable_point_map(PointRange& points)
{
  return {&points};
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_POINT_MAP_H
