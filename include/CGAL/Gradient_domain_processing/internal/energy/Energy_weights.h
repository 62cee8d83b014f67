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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_ENERGY_WEIGHTS_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_ENERGY_WEIGHTS_H

#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// alpha, beta and lambda of the energy (eq. 1). The vectors are empty where a weight is the same everywhere.
struct Energy_weights
{
  double value = 1;
  double gradient = 0; // a squared length, in units of the arrays
  double scale = 0;
  std::vector<double> value_at_vertex;
  std::vector<double> gradient_at_triangle;
  std::vector<double> scale_at_triangle;

  double value_at(int v) const { return value_at_vertex.empty() ? value : value_at_vertex[v]; }
  double gradient_at(int f) const { return gradient_at_triangle.empty() ? gradient : gradient_at_triangle[f]; }
  double scale_at(int f) const { return scale_at_triangle.empty() ? scale : scale_at_triangle[f]; }

  void set_value(double alpha)
  {
    value = alpha;
    value_at_vertex.clear();
  }
  void set_gradient(double beta)
  {
    gradient = beta;
    gradient_at_triangle.clear();
  }
  void set_scale(double lambda)
  {
    scale = lambda;
    scale_at_triangle.clear();
  }
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_ENERGY_ENERGY_WEIGHTS_H
