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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_TANGENT_FRAME_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_TANGENT_FRAME_H

#include <CGAL/Gradient_domain_processing/internal/curvature/Principal_curvatures.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Two orthonormal tangent vectors.
struct Tangent_frame
{
  Vec3 e1, e2;
};

// Some frame orthogonal to `normal`; the same one for the same normal. A zero or non-finite normal counts as the z
// axis.
inline Tangent_frame frame_of_normal(const Vec3& normal)
{
  const double size = normal.cwiseAbs().maxCoeff();
  const bool known = size > 0 && normal.allFinite();
  const Vec3 n = known ? Vec3((normal / size).normalized()) : Vec3(Vec3::UnitZ());

  // the axis farthest from the normal
  int axis = 0;
  n.cwiseAbs().minCoeff(&axis);

  Tangent_frame frame;
  frame.e1 = n.cross(Vec3::Unit(axis)).normalized();
  frame.e2 = n.cross(frame.e1);
  return frame;
}

inline Principal_curvatures flat_curvatures(const Tangent_frame& frame)
{
  return { 0., 0., frame.e1, frame.e2 };
}

// Eigenpairs of the curvature tensor [a b; b c] given in `frame`. The larger eigenvector is built from the sum that
// does not cancel; the frame itself answers for an umbilic point.
inline Principal_curvatures diagonalize(double a, double b, double c, const Tangent_frame& frame)
{
  const double mean = a / 2 + c / 2;
  const double difference = a / 2 - c / 2;
  const double radius = std::hypot(difference, b);

  double x = 1, y = 0;
  if(radius > 0)
  {
    x = difference >= 0 ? difference + radius : b;
    y = difference >= 0 ? b : radius - difference;
    const double length = std::hypot(x, y);
    x /= length;
    y /= length;
  }
  return { mean - radius, mean + radius, x * frame.e2 - y * frame.e1, x * frame.e1 + y * frame.e2 };
}

// A triangle in its own plane: corner `first` at the origin, the next one at (length, 0), the last one at (x, height),
// where the side on the first axis is the longest, so that 0 <= x <= length.
struct Planar_triangle
{
  Tangent_frame frame;
  int first;
  double length, x, height;
  bool is_degenerate;   // no height beyond rounding: the plane is unknown, the frame an arbitrary one
};

inline Planar_triangle planar_triangle(const Vec3& p0, const Vec3& p1, const Vec3& p2)
{
  const Vec3 sides[3] = { p1 - p0, p2 - p1, p0 - p2 };
  const double size = (std::max)({ sides[0].cwiseAbs().maxCoeff(), sides[1].cwiseAbs().maxCoeff(),
                                   sides[2].cwiseAbs().maxCoeff() });

  Planar_triangle t;
  t.first = 0;
  t.length = t.x = t.height = 0;
  t.is_degenerate = true;
  if(!(size > 0) || !std::isfinite(size))
  {
    t.frame = frame_of_normal(Vec3::Zero());
    return t;
  }

  // lengths are squared at size 1 only, so that no scale overflows or underflows
  double longest = 0;
  for(int i = 0; i < 3; ++i)
  {
    const double squared_length = (sides[i] / size).squaredNorm();
    if(squared_length > longest)
    {
      longest = squared_length;
      t.first = i;
    }
  }
  const Vec3 base = sides[t.first] / size;
  const Vec3 to_apex = -sides[(t.first + 2) % 3] / size;
  const double base_length = std::sqrt(longest);
  t.frame.e1 = base / base_length;
  const double x = to_apex.dot(t.frame.e1);

  // orthogonalised twice: once leaves a needle's height polluted by its length
  Vec3 up = to_apex - x * t.frame.e1;
  up -= up.dot(t.frame.e1) * t.frame.e1;
  const double height = up.norm();

  t.length = size * base_length;
  t.x = size * x;
  t.height = size * height;
  t.is_degenerate = !(height > 1e-12 * base_length && t.height > 1e-300); // one over the height is finite
  t.frame.e2 = t.is_degenerate ? frame_of_normal(t.frame.e1).e1 : Vec3(up / height);
  return t;
}

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_TANGENT_FRAME_H
