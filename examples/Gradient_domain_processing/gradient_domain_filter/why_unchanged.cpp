// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "why_unchanged.h"
#include "signal.h"

#include <algorithm>

namespace {

bool all_are(const Options& options, const Mesh_file& file, const std::string& property, double value)
{
  if(property.empty())
    return false;
  const std::vector<double>& values = vertex_property(options, file, property);
  return std::all_of(values.begin(), values.end(), [&](double x) { return x == value; });
}

bool all_are_constrained(const Options& options, const Mesh_file& file)
{
  if(options.constrained_property.empty())
    return false;
  const std::vector<double>& values = vertex_property(options, file, options.constrained_property);
  return std::all_of(file.polygons.corners.begin(), file.polygons.corners.end(),
                     [&](int v) { return values[std::size_t(v)] != 0; });
}

bool is_constant(const std::vector<std::vector<double> >& signal)
{
  return std::all_of(signal.begin(), signal.end(), [](const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [&](double x) { return x == values[0]; });
  });
}

// As normals of flat shading are.
bool is_constant_on_faces(const Mesh_file& file, const std::vector<std::vector<double> >& signal)
{
  return std::all_of(signal.begin(), signal.end(), [&](const std::vector<double>& values) {
    return values.size() == file.points.size()
           && std::all_of(file.polygons.begin(), file.polygons.end(), [&](const auto& polygon) {
                return std::all_of(polygon.begin(), polygon.end(), [&](int v) {
                  return values[std::size_t(v)] == values[std::size_t(polygon[0])];
                });
              });
  });
}

} // namespace

std::string why_unchanged(const Options& o, const Mesh_file& file, const std::vector<std::vector<double> >& signal)
{
  if(o.max_displacement && *o.max_displacement == 0)
    return "the largest displacement is 0";
  if(all_are_constrained(o, file))
    return "all vertices are constrained";
  if(o.is_of_paper() && o.hessian_weight == 0)
  {
    if(o.gradient_weight == 0 && o.gradient_weight_property.empty())
      return "the gradient weight is 0";
    if(all_are(o, file, o.gradient_weight_property, 0))
      return "the gradient weight is 0, as " + o.gradient_weight_property + " is at all vertices";
    const bool filters_normals = o.signal == Signal_kind::NORMAL_TO_POSITION;
    if(!filters_normals && o.gradient_scale == 1 && o.gradient_scale_property.empty())
      return "the gradient scale is 1";
    if(!filters_normals && all_are(o, file, o.gradient_scale_property, 1))
      return "the gradient scale is 1, as " + o.gradient_scale_property + " is at all vertices";
    if(filters_normals && o.gradient_scale == 1 && o.gradient_scale_property.empty())
      return "the normals are those that the surface has; --gradient-weight filters them first";
  }
  if(!o.moves_vertices() && is_constant(signal))
    return "the signal is the same everywhere";
  if(!o.moves_vertices() && is_constant_on_faces(file, signal))
    return "on every face the signal is the same at all corners, so it has no gradients";
  if(o.is_band())
    return "there are no waves on this surface that the filter would take away";
  if(!o.constrained_property.empty() || o.border != CGAL::Gradient_domain_processing::Border_condition::FREE
     || o.non_manifold != CGAL::Gradient_domain_processing::Border_condition::FREE)
    return "all vertices are constrained, or in places that the filter leaves as they are";
  return "the filter leaves the signal as it is, or the gradient weight is too small";
}
