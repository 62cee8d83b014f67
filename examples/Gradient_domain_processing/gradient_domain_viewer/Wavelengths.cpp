// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Wavelengths.h"

#include <CGAL/Bbox_3.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

const double two_pi = 2 * std::acos(-1.);

double length(const Vector& v) { return std::sqrt(v.squared_length()); }

} // namespace

Wavelengths::Wavelengths(const std::vector<Point>& points, const Polygons& polygons)
{
  double area = 0, edges = 0;
  CGAL::Bbox_3 box;
  for(const auto& polygon : polygons)
  {
    Vector normal(0, 0, 0);
    for(std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Point &p = points[std::size_t(polygon[i])], &q = points[std::size_t(polygon[(i + 1) % polygon.size()])];
      const Point& first = points[std::size_t(polygon[0])];
      normal = normal + CGAL::cross_product(p - first, q - first);
      edges += length(q - p);
      box += p.bbox();
    }
    area += length(normal) / 2;
  }
  if(!(area > 0) || !(edges > 0))
    return;
  m_area = area;
  m_mean_edge = edges / double(polygons.corners.size());
  m_diagonal = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

double Wavelengths::wavelength(double weight) const { return two_pi * std::sqrt(weight * m_area); }

double Wavelengths::weight(double wavelength) const
{
  const double root = wavelength / two_pi;
  return root * root / m_area;
}

double Wavelengths::radius(double curvature_weight) const { return std::sqrt(curvature_weight * m_area); }

double rounded(double weight)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.3g", weight);
  return std::strtod(text, nullptr);
}
