// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_VIEWER_WAVELENGTHS_H
#define GRADIENT_DOMAIN_VIEWER_WAVELENGTHS_H

#include "files/Mesh_file.h"

#include <vector>

// Weights as lengths that can be seen. With lambda = 0 and alpha = 1 a wave of length L keeps the part
// 1 / (1 + beta (2 pi / L)^2) of its height: one half where L = 2 pi sqrt(beta).
class Wavelengths
{
  double m_area = 1, m_mean_edge = 1, m_diagonal = 1;

public:
  Wavelengths() = default;
  Wavelengths(const std::vector<Point>& points, const Polygons& polygons);

  double area() const { return m_area; }
  double mean_edge() const { return m_mean_edge; }
  double diagonal() const { return m_diagonal; }

  // In the unit of the mesh; weights are relative to the area.
  double wavelength(double weight) const;
  double weight(double wavelength) const;

  // The radius below which a bend is stretched to more than twice its squared length by a curvature weight.
  double radius(double curvature_weight) const;
};

// As it is written in a command line: three digits are enough, and are all there is.
double rounded(double weight);

#endif // GRADIENT_DOMAIN_VIEWER_WAVELENGTHS_H
