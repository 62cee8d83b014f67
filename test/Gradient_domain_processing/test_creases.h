// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_CREASES_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_CREASES_H

#include "test_shapes.h"
#include "test_utils.h"

#include <CGAL/Gradient_domain_processing/smooth.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

// How well filters keep creases (paper, Figure 1). They are compared where they leave the same noise: each can keep
// more by smoothing less.
namespace gdp_test {

namespace GDP = CGAL::Gradient_domain_processing;

typedef GDP::Curvature_metric_kind Kind;

struct Filter
{
  Kind kind = Kind::EMBEDDING;
  double curvature_weight = 0.02, presmoothing_weight = 1e-4;
  GDP::Border_condition border_condition = GDP::Border_condition::FREE;
  unsigned int passes = 1;
};

inline Mesh smoothed(const Mesh& mesh, double weight, const Filter& filter, double scale = 0)
{
  Mesh result = mesh;
  GDP_CHECK(GDP::smooth(result, GDP::parameters::gradient_weight(weight)
                                  .gradient_scale(scale)
                                  .curvature_metric_kind(filter.kind)
                                  .curvature_weight(filter.curvature_weight)
                                  .presmoothing_weight(filter.presmoothing_weight)
                                  .border_condition(filter.border_condition)
                                  .number_of_iterations(filter.passes))
            == GDP::OK);
  return result;
}

// in degrees
inline double angle(const Vec& a, const Vec& b)
{
  return 2 * std::asin((std::min)(1., (a.normalized() - b.normalized()).norm() / 2)) * 180 / pi;
}

// Smoothed until so much noise is left. A part has a mesh `noisy`, and measures residual_noise() and crease_error() of
// what became of it.
template <class Part>
Mesh smoothed_to(const Part& part, double noise, const Filter& filter)
{
  Mesh result;
  double weight = 1e-6, ratio = 0;
  for(int step = 0; step < 20; ++step)
  {
    result = smoothed(part.noisy, weight, filter);
    ratio = part.residual_noise(result) / noise;
    if(std::abs(ratio - 1) < 0.01)
      break;
    weight *= ratio * ratio; // about how they are related
  }
  GDP_CHECK_NEAR(ratio, 1, 0.01);
  return result;
}

struct Smoothed_part
{
  Mesh isotropic, edge_aware, anisotropic;
};

// `remaining` is the share of the noise that is left.
template <class Part>
Smoothed_part test_creases(const std::string& name, const Part& part, double remaining, Filter filter)
{
  const double noise = remaining * part.residual_noise(part.noisy);
  Smoothed_part result;
  const auto error = [&](Kind kind, Mesh& mesh) {
    filter.kind = kind;
    mesh = smoothed_to(part, noise, filter);
    return part.crease_error(mesh);
  };
  const double isotropic = error(Kind::EMBEDDING, result.isotropic);
  const double edge_aware = error(Kind::EDGE_AWARE, result.edge_aware);
  const double anisotropic = error(Kind::ANISOTROPIC, result.anisotropic);
  std::cout << name << ": dihedral angles off by " << isotropic << " degrees (isotropic), " << edge_aware
            << " (edge aware, " << isotropic / edge_aware << " times better), " << anisotropic << " (anisotropic, "
            << isotropic / anisotropic << " times better)" << std::endl;
  GDP_CHECK(isotropic / edge_aware > 2);
  GDP_CHECK(anisotropic < 0.95 * edge_aware);
  return result;
}

} // namespace gdp_test

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_TEST_CREASES_H
