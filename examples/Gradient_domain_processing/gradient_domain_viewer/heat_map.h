// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_VIEWER_HEAT_MAP_H
#define GRADIENT_DOMAIN_VIEWER_HEAT_MAP_H

#include "Drawn_surface.h"

#include <string>
#include <vector>

// Colors, and in words what the darkest of them stand for.
struct Heat_map
{
  std::vector<Rgb> colors;
  std::string legend;
};

// Blue inwards, red outwards.
Heat_map displacement_map(const std::vector<double>& displacements);
// Blue where it is flat, red where it is bent; logarithmic, from the 5th to the 95th percentile.
Heat_map curvature_map(const std::vector<double>& curvatures);

#endif // GRADIENT_DOMAIN_VIEWER_HEAT_MAP_H
