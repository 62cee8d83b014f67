// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface_view.h"

#include <vtkCamera.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkWorldPointPicker.h>

#include <QMouseEvent>

Surface_view::Surface_view(QWidget* parent) : QVTKOpenGLNativeWidget(parent)
{
  m_window->SetMultiSamples(0);
  setRenderWindow(m_window);
  m_window->AddRenderer(m_renderer);
  m_renderer->SetBackground(1, 1, 1);
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor()->SetInteractorStyle(style);
  setFocusPolicy(Qt::NoFocus); // keys are the window's
}

Drawn_surface& Surface_view::show_surface(const std::vector<Point>& points, const Polygons& polygons)
{
  m_renderer->RemoveAllViewProps();
  m_surface = std::make_unique<Drawn_surface>(points, polygons);
  m_renderer->AddActor(m_surface->actor());
  m_renderer->ResetCamera();
  m_renderer->GetActiveCamera()->Zoom(1.3);
  return *m_surface;
}

void Surface_view::turn(double azimuth, double elevation, double zoom)
{
  vtkCamera* const camera = m_renderer->GetActiveCamera();
  camera->Azimuth(azimuth);
  camera->Elevation(elevation);
  camera->OrthogonalizeViewUp();
  camera->Zoom(zoom);
  m_renderer->ResetCameraClippingRange();
}

void Surface_view::draw() { m_window->Render(); }

void Surface_view::mousePressEvent(QMouseEvent* event)
{
  m_is_painting = dab && event->button() == Qt::LeftButton;
  if(m_is_painting)
    paint_at(*event);
  else
    QVTKOpenGLNativeWidget::mousePressEvent(event);
}

void Surface_view::mouseMoveEvent(QMouseEvent* event)
{
  if(m_is_painting)
    paint_at(*event);
  else
    QVTKOpenGLNativeWidget::mouseMoveEvent(event);
}

void Surface_view::mouseReleaseEvent(QMouseEvent* event)
{
  if(!m_is_painting)
    return QVTKOpenGLNativeWidget::mouseReleaseEvent(event);
  m_is_painting = false;
  stroke_ends();
}

// The depth that was drawn there says where the surface is.
void Surface_view::paint_at(const QMouseEvent& event)
{
  const double ratio = devicePixelRatioF();
  const int x = int(event.x() * ratio), y = int((height() - 1 - event.y()) * ratio);
  makeCurrent();
  vtkNew<vtkWorldPointPicker> picker;
  picker->Pick(x, y, 0, m_renderer);
  if(m_renderer->GetZ(x, y) >= 1)
    return; // beside the surface
  const double* const p = picker->GetPickPosition();
  dab(Point(p[0], p[1], p[2]), !(event.modifiers() & Qt::ShiftModifier));
}
