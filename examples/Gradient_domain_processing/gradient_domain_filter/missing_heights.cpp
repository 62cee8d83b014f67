// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "filter_parts.h"

#include <CGAL/Gradient_domain_processing/process_signal.h>

#include <algorithm>
#include <cmath>

using namespace filter_mesh_impl;

// The heights are a signal on the ground, that is, on the same surface without them.
Error_code fill_missing_heights(const Options& options, Mesh_file& file, Stage_clock& clock)
{
  const int axis =
    int(std::find(options.moves_along.begin(), options.moves_along.end(), true) - options.moves_along.begin());
  std::vector<double> heights;
  std::vector<char> is_missing(file.points.size(), 0);
  std::vector<Point> ground;
  for(const Point& p : file.points)
  {
    heights.push_back(p[axis]);
    ground.emplace_back(axis == 0 ? 0 : p.x(), axis == 1 ? 0 : p.y(), axis == 2 ? 0 : p.z());
  }
  std::size_t missing = 0;
  for(int v : file.polygons.corners)
    if(std::isnan(heights[std::size_t(v)]) && !is_missing[std::size_t(v)])
    {
      is_missing[std::size_t(v)] = 1;
      ++missing;
    }
  if(missing == 0)
    return GDP::ok;
  const Array_map<double> map{&heights};
  const auto np = GDP::parameters::missing_values(true).number_of_iterations(0).visitor(std::ref(clock))
    .weld_tolerance(options.weld_tolerance.value_or(-1));
  if(const Error_code code = GDP::process_signal(ground, file.polygons, map, map, np))
    return code;
  for(std::size_t v = 0; v < ground.size(); ++v)
    if(is_missing[v])
      file.points[v] = Point(axis == 0 ? heights[v] : ground[v].x(), axis == 1 ? heights[v] : ground[v].y(),
                             axis == 2 ? heights[v] : ground[v].z());
  clock.notice(std::to_string(missing) + (missing == 1 ? " missing height was" : " missing heights were")
               + " filled in");
  return GDP::ok;
}
