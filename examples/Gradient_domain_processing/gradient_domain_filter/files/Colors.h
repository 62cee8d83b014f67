// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_FILTER_FILES_COLORS_H
#define GRADIENT_DOMAIN_FILTER_FILES_COLORS_H

#include "Mesh_file.h"

#include <algorithm>
#include <cmath>

// The value of full brightness: formats and files do not agree about it. Bytes go to 255, reals to 1, unless one is
// larger.
inline double white(const Columns& columns)
{
  double largest = 0;
  for(const char* name : {"red", "green", "blue", "alpha"})
    if(const Column* const column = columns.find(name))
    {
      if(is_integer(column->type))
        return column->type == Number_type::UINT16 ? 65535. : 255.;
      for(double x : column->values)
        largest = (std::max)(largest, x);
    }
  return largest <= 1 ? 1. : 255.;
}

// From 0 to 1.
inline double unit_color(double x, double white) { return (std::min)((std::max)(x / white, 0.), 1.); }

#endif // GRADIENT_DOMAIN_FILTER_FILES_COLORS_H
