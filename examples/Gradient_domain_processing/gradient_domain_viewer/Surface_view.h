// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_VIEWER_SURFACE_VIEW_H
#define GRADIENT_DOMAIN_VIEWER_SURFACE_VIEW_H

#include "Drawn_surface.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <functional>
#include <memory>

class QMouseEvent;

// The part of the window that shows the surface. With a brush the left button paints; else the mouse turns the view.
class Surface_view : public QVTKOpenGLNativeWidget
{
  vtkNew<vtkGenericOpenGLRenderWindow> m_window;
  vtkNew<vtkRenderer> m_renderer;
  std::unique_ptr<Drawn_surface> m_surface;
  bool m_is_painting = false;

public:
  std::function<void(const Point&, bool is_painted)> dab; // none: there is no brush
  std::function<void()> stroke_ends;

  explicit Surface_view(QWidget* parent);

  Drawn_surface& show_surface(const std::vector<Point>& points, const Polygons& polygons);
  void turn(double azimuth, double elevation, double zoom);
  void draw();

protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

private:
  void paint_at(const QMouseEvent& event);
};

#endif // GRADIENT_DOMAIN_VIEWER_SURFACE_VIEW_H
