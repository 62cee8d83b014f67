// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Drawn_surface.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

Rgb mixed(const Rgb& a, const Rgb& b, double t)
{
  Rgb color;
  for(std::size_t i = 0; i < 3; ++i)
    color[i] = static_cast<unsigned char>(std::lround((1 - t) * a[i] + t * b[i]));
  return color;
}

Rgb heat_color(double t)
{
  const double part = std::isfinite(t) ? (std::min)(std::abs(t), 1.) : 0;
  return mixed(clay, t < 0 ? Rgb{{33, 84, 190}} : Rgb{{196, 30, 38}}, part);
}

Drawn_surface::Drawn_surface(const std::vector<Point>& points, const Polygons& polygons)
{
  vtkNew<vtkCellArray> cells;
  cells->AllocateEstimate(vtkIdType(polygons.size()), 3);
  for(const auto& polygon : polygons)
  {
    cells->InsertNextCell(int(polygon.size()));
    for(int v : polygon)
      cells->InsertCellPoint(v);
  }
  m_points->SetNumberOfPoints(vtkIdType(points.size()));
  m_colors->SetNumberOfComponents(3);
  m_colors->SetNumberOfTuples(vtkIdType(points.size()));
  m_data->SetPoints(m_points);
  m_data->SetPolys(cells);
  m_data->GetPointData()->SetScalars(m_colors);
  m_mapper->SetInputData(m_data);
  m_actor->SetMapper(m_mapper);
  m_actor->GetProperty()->SetInterpolationToFlat();
  m_actor->GetProperty()->SetAmbient(0.1);
  m_actor->GetProperty()->SetSpecular(0.15);
  m_actor->GetProperty()->SetSpecularPower(20);
  set_points(points);
  set_colors(std::vector<Rgb>(points.size(), clay));
}

void Drawn_surface::set_points(const std::vector<Point>& points)
{
  for(std::size_t v = 0; v < points.size(); ++v)
    m_points->SetPoint(vtkIdType(v), points[v].x(), points[v].y(), points[v].z());
  m_points->Modified();
}

void Drawn_surface::set_colors(const std::vector<Rgb>& colors)
{
  if(colors == m_shown)
    return; // they need not be sent to the screen again
  m_shown = colors;
  for(std::size_t v = 0; v < colors.size(); ++v)
    m_colors->SetTypedTuple(vtkIdType(v), colors[v].data());
  m_colors->Modified();
}
