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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_SIGNALS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_SIGNALS_H

#include <CGAL/Gradient_domain_processing/Error_code.h>
#include <CGAL/Gradient_domain_processing/Signal_traits.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/Surface_elements.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/points.h>
#include <CGAL/Gradient_domain_processing/internal/mesh/polygon_fans.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// A signal by rows, those of virtual vertices included. NaN is let through where it means a missing value.
template <class InMap, class Surface>
Error_code read_signal(InMap in, const Surface_elements<Surface>& elements, const Indexed_triangles& mesh,
                       bool may_be_missing, Culprit& culprit, Signal& signal)
{
  typedef Signal_traits<typename boost::property_traits<InMap>::value_type> Traits;
  signal.resize(mesh.number_of_rows(), Traits::dimension);
  for(int row = 0; row < mesh.number_of_surface_vertices(); ++row)
  {
    const auto& value = get(in, elements.vertices[row]);
    for(int i = 0; i < Traits::dimension; ++i)
    {
      signal(row, i) = Traits::channel(value, i);
      const bool is_used = mesh.corners.size(mesh.vertex_of(row)) > 0;
      if(!std::isfinite(signal(row, i)) && is_used && !(may_be_missing && std::isnan(signal(row, i))))
      {
        culprit.row = row;
        return error_invalid_signal;
      }
    }
  }
  interpolate_virtual_rows(mesh, signal);
  return ok;
}

// Values that were not solved for are copied, so that they stay the same to the bit.
template <class InMap, class OutMap, class Surface, class Is_moved>
Error_code write_signal(InMap in, const Signal& result, OutMap out, const Surface_elements<Surface>& elements,
                        const Indexed_triangles& mesh, const Is_moved& is_moved, Culprit& culprit)
{
  typedef typename boost::property_traits<InMap>::value_type In_value;
  typedef typename boost::property_traits<OutMap>::value_type Out_value;
  typedef Signal_traits<Out_value> Traits;
  static_assert(Signal_traits<In_value>::dimension == Traits::dimension, "input and output have as many channels");

  std::vector<Out_value> values;
  values.reserve(mesh.number_of_surface_vertices());
  for(int row = 0; row < mesh.number_of_surface_vertices(); ++row)
  {
    values.push_back(Traits::make(result.data() + row * result.cols()));
    const bool moves = is_moved(mesh.vertex_of(row));
    for(int i = 0; i < Traits::dimension; ++i)
      if(moves && !std::isfinite(Traits::channel(values.back(), i)))
      {
        culprit.row = row;
        return error_result_out_of_range;
      }
    if constexpr (std::is_same<In_value, Out_value>::value)
      if(!moves)
        values.back() = get(in, elements.vertices[row]);
  }
  for(std::size_t row = 0; row < values.size(); ++row)
    put(out, elements.vertices[row], values[row]);
  return ok;
}

// Vectors by row.
template <class Map, class Surface>
Error_code read_vectors(Map map, const Surface_elements<Surface>& elements, const Indexed_triangles& mesh,
                        Culprit& culprit, Signal& vectors)
{
  vectors.resize(mesh.number_of_rows(), 3);
  for(int row = 0; row < mesh.number_of_surface_vertices(); ++row)
  {
    const Vec3 v = to_vec3(get(map, elements.vertices[row]));
    if(!v.allFinite())
    {
      culprit.row = row;
      return error_invalid_target;
    }
    vectors.row(row) = v.transpose();
  }
  interpolate_virtual_rows(mesh, vectors);
  return ok;
}

// By vertex: the mean over its rows.
Signal mean_by_vertex(const Indexed_triangles& mesh, const Signal& signal);
std::vector<Vec3> mean_over_rows(const Indexed_triangles& mesh, const Signal& vectors);

// The points of a surface that moved: of a seam, all sides by the same vector.
template <class PointMap, class Surface, class Is_moved>
Error_code write_points(PointMap map, const Surface_elements<Surface>& elements, const Indexed_triangles& mesh,
                        const std::vector<Vec3>& before, const Is_moved& is_moved, Culprit& culprit)
{
  typedef typename boost::property_traits<PointMap>::value_type Point;
  const double unit = mesh.unit();
  std::vector<Point> points;
  points.reserve(elements.vertices.size());
  for(int row = 0; row < mesh.number_of_surface_vertices(); ++row)
  {
    const int v = mesh.vertex_of(row);
    Vec3 p = unit * mesh.points[v];
    if(!mesh.vertex_of_row.empty())
    {
      const Vec3 own = to_vec3(get(map, elements.vertices[row]));
      if(own != Vec3(unit * before[v]))
        p = own + unit * (mesh.points[v] - before[v]);
    }
    points.push_back(to_point<Point>(p));
    if(is_moved(v) && !to_vec3(points.back()).allFinite())
    {
      culprit.row = row;
      return error_result_out_of_range;
    }
  }
  for(int row = 0; row < mesh.number_of_surface_vertices(); ++row)
    if(is_moved(mesh.vertex_of(row)))
      put(map, elements.vertices[row], points[row]);
  return ok;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED
#include <CGAL/Gradient_domain_processing/internal/mesh/signals_impl.h>
#endif

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_MESH_SIGNALS_H
