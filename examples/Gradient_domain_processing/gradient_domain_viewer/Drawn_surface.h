// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_VIEWER_DRAWN_SURFACE_H
#define GRADIENT_DOMAIN_VIEWER_DRAWN_SURFACE_H

#include "files/Mesh_file.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <vector>

typedef std::array<unsigned char, 3> Rgb;

constexpr Rgb clay = {{214, 208, 196}};

// Blue at -1 over clay to red at 1.
Rgb heat_color(double t);
// The part of the way from one color to another.
Rgb mixed(const Rgb& a, const Rgb& b, double t);

// A surface in a scene of VTK, with a color at every vertex; its faces are flat, so that noise is seen.
class Drawn_surface
{
  vtkNew<vtkPoints> m_points;
  vtkNew<vtkPolyData> m_data;
  vtkNew<vtkUnsignedCharArray> m_colors;
  std::vector<Rgb> m_shown; // those that m_colors has
  vtkNew<vtkPolyDataMapper> m_mapper;
  vtkNew<vtkActor> m_actor;

public:
  Drawn_surface(const std::vector<Point>& points, const Polygons& polygons);

  void set_points(const std::vector<Point>& points);
  void set_colors(const std::vector<Rgb>& colors);
  vtkActor* actor() const { return m_actor.Get(); }
};

#endif // GRADIENT_DOMAIN_VIEWER_DRAWN_SURFACE_H
