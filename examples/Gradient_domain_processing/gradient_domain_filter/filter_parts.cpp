// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "filter_parts.h"

#include <algorithm>

namespace filter_mesh_impl {

Filter_input::Filter_input(const Options& options, const Mesh_file& file) : is_constrained(file.points.size(), 0)
{
  if(!options.constrained_property.empty())
  {
    const std::vector<double>& selected = vertex_property(options, file, options.constrained_property);
    std::transform(selected.begin(), selected.end(), is_constrained.begin(), [](double x) { return x != 0; });
  }
  has_region = !options.region_property.empty();
  if(has_region)
  {
    const std::vector<double>& selected = vertex_property(options, file, options.region_property);
    for(std::size_t f = 0; f < file.polygons.size(); ++f)
    {
      const auto polygon = file.polygons[f];
      if(std::all_of(polygon.begin(), polygon.end(), [&](int v) { return selected[std::size_t(v)] != 0; }))
        region.push_back(f);
    }
  }
  for(std::size_t i = 0; i < 3; ++i)
    if(options.moves_along[i])
      movable_axes += "xyz"[i];
}

std::vector<double> at_faces(const Options& options, const Mesh_file& file, const std::string& name)
{
  std::vector<double> values;
  if(name.empty())
    return values;
  const std::vector<double>& at_vertices = vertex_property(options, file, name);
  values.reserve(file.polygons.size());
  for(const auto& polygon : file.polygons)
  {
    double sum = 0;
    for(int v : polygon)
      sum += at_vertices[std::size_t(v)];
    values.push_back(sum / double(polygon.size()));
  }
  return values;
}

} // namespace filter_mesh_impl
