// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "heat_map.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

double percentile(std::vector<double> values, double part)
{
  const auto place = values.begin() + std::ptrdiff_t(part * double(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

std::string text(double x)
{
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.3g", x);
  return buffer;
}

} // namespace

Heat_map displacement_map(const std::vector<double>& displacements)
{
  double largest = 0;
  for(double x : displacements)
    largest = (std::max)(largest, std::abs(x));
  Heat_map map;
  for(double x : displacements)
    map.colors.push_back(heat_color(largest > 0 ? x / largest : 0));
  map.legend = "blue: " + text(largest) + " inwards, red: " + text(largest) + " outwards";
  return map;
}

Heat_map curvature_map(const std::vector<double>& curvatures)
{
  Heat_map map;
  if(curvatures.empty())
    return map;
  const double least = (std::max)(percentile(curvatures, 0.05), 1e-300),
               most = (std::max)(percentile(curvatures, 0.95), least);
  const double range = std::log(most / least);
  for(double k : curvatures)
  {
    const double t = range > 0 ? std::log((std::max)(k, 1e-300) / least) / range : 0.5;
    map.colors.push_back(heat_color((std::min)((std::max)(2 * t - 1, -1.), 1.)));
  }
  map.legend = "blue: radius " + text(1 / std::sqrt(least)) + " and flatter, red: radius " + text(1 / std::sqrt(most))
             + " and sharper";
  return map;
}
