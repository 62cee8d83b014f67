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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_POINTS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_POINTS_H

#include <CGAL/Gradient_domain_processing/Signal_traits.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Indexed_triangles.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

template <class Point, class = void>
struct Has_subscript : std::false_type {};
template <class Point>
struct Has_subscript<Point, decltype(void(std::declval<const Point&>()[0]))> : std::true_type {};

template <class Point, class = void>
struct Has_xyz : std::false_type {};
template <class Point>
struct Has_xyz<Point, decltype(void(std::declval<const Point&>().x()), void(std::declval<const Point&>().y()),
                               void(std::declval<const Point&>().z()))> : std::true_type {};

template <class Point>
Vec3 to_vec3(const Point& p)
{
  static_assert(Has_subscript<Point>::value || Has_xyz<Point>::value,
                "points and vectors have an operator[] or x(), y(), z(), and can be made from three coordinates");
  if constexpr (Has_subscript<Point>::value)
    return Vec3(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]));
  else
    return Vec3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

// The point as its type holds it.
template <class Point>
Point to_point(const Vec3& p)
{
  if constexpr (Has_subscript<Point>::value)
  {
    static_assert(Signal_traits<Point>::dimension == 3,
                  "Signal_traits says how points that have an operator[] are made of three coordinates");
    return Signal_traits<Point>::make(p.data());
  }
  else
  {
    typedef typename std::decay<decltype(std::declval<const Point&>().x())>::type Coordinate;
    static_assert(std::is_constructible<Point, Coordinate, Coordinate, Coordinate>::value,
                  "points can be made from three coordinates");
    return Point(Coordinate(p[0]), Coordinate(p[1]), Coordinate(p[2]));
  }
}

constexpr double largest_coordinate = 1e150;

inline bool is_valid_point(const Vec3& p)
{
  for(int i = 0; i < 3; ++i)
    if(!(std::abs(p[i]) <= largest_coordinate)) // as NaN is not
      return false;
  return true;
}

// Multiplies the points by the power of two that brings their extent near one.
void normalize_extent(Indexed_triangles& mesh);

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/mesh/points_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_POINTS_H
