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

#ifndef CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_JET_FITTER_H
#define CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_JET_FITTER_H

#include <CGAL/Gradient_domain_processing/internal/curvature/Jet_least_squares.h>
#include <CGAL/Gradient_domain_processing/internal/curvature/tangent_frame.h>

#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Gradient_domain_processing {
namespace internal {

// Fits a jet to a neighborhood; where its points do not determine one of this degree, one of the next lower degree.
// The neighborhood begins with the vertex, which is at the origin, and its extent is about one.
template <class Kernel = Simple_cartesian<double> >
class Jet_fitter
{
public:
  typedef typename Kernel::Point_3 Point;
  typedef std::vector<Point> Points;
  static constexpr std::size_t max_number_of_points = Jet_least_squares<double>::max_number_of_points;

  explicit Jet_fitter(int degree) : m_degree(degree) {}

  // False, and `result` untouched, where no degree from two on has an answer.
  bool operator()(const Points& points, const Vec3& normal, Principal_curvatures& result)
  {
    for(int degree = m_degree; degree >= 2; --degree)
      if(fit(points, normal, degree, result))
        return true;
    return false;
  }

private:
  typedef Monge_via_jet_fitting<Kernel, Kernel, Jet_least_squares<double> > Monge_via_jet;

  // Beyond it, rounding of the coordinates decides what the coefficients are.
  static constexpr double max_condition_number = 1e8;

  bool fit(const Points& points, const Vec3& normal, int degree, Principal_curvatures& result)
  {
    if(points.size() < number_of_jet_coefficients(degree))
      return false;

    typename Monge_via_jet::Monge_form monge = m_monge(points.begin(), points.end(), std::size_t(degree), 2);
    if(!(m_monge.condition_number() < max_condition_number))
      return false;

    // A height above the tangent plane bends down, away from the outward normal, where the surface is convex: hence the
    // signs.
    monge.comply_wrt_given_normal(typename Kernel::Vector_3(normal.x(), normal.y(), normal.z()));
    const Principal_curvatures fitted = { -monge.principal_curvatures(0), -monge.principal_curvatures(1),
                                          as_unit(monge.maximal_principal_direction()),
                                          as_unit(monge.minimal_principal_direction()) };
    if(!std::isfinite(fitted.min_curvature) || !std::isfinite(fitted.max_curvature) ||
       !fitted.min_direction.allFinite() || !fitted.max_direction.allFinite())
      return false;
    result = fitted;
    return true;
  }

  static Vec3 as_unit(const typename Kernel::Vector_3& v)
  {
    return Vec3(v.x(), v.y(), v.z()).normalized();
  }

  int m_degree;
  Monge_via_jet m_monge;
};

} // namespace internal
} // namespace Gradient_domain_processing
} // namespace CGAL

#endif // CGAL_GRADIENT_DOMAIN_PROCESSING_INTERNAL_CURVATURE_JET_FITTER_H
