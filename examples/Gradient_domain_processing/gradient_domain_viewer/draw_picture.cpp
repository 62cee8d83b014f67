// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "draw_picture.h"
#include "Drawn_surface.h"
#include "Failure.h"
#include "heat_map.h"

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>

namespace {

constexpr int panel_width = 480, panel_height = 460, number_of_panels = 3;

// On the broadest side, along z if that is as good; a little from the side and from above.
void aim(vtkCamera* camera, const double* bounds)
{
  const auto extent = [&](int i) { return bounds[2 * i + 1] - bounds[2 * i]; };
  int axis = 2;
  for(int i : {0, 1})
    if(extent(i) < 0.85 * extent(axis))
      axis = i;
  const int up = axis == 1 ? 2 : 1, side = 3 - axis - up;
  double from[3], above[3] = {0, 0, 0};
  from[axis] = 1;
  from[side] = 0.42;
  from[up] = 0.34;
  above[up] = 1;
  camera->SetPosition(from);
  camera->SetViewUp(above);
}

void add_panel(vtkRenderWindow* window, int place, vtkActor* actor, vtkCamera* camera, const std::string& caption)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetViewport(double(place) / number_of_panels, 0, double(place + 1) / number_of_panels, 1);
  renderer->SetBackground(1, 1, 1);
  renderer->AddActor(actor);
  renderer->SetActiveCamera(camera);
  vtkNew<vtkTextActor> text;
  text->SetInput(caption.c_str());
  text->SetPosition(12, 8);
  text->GetTextProperty()->SetFontSize(15);
  text->GetTextProperty()->SetColor(0.15, 0.15, 0.15);
  renderer->AddViewProp(text);
  window->AddRenderer(renderer);
  if(place == 0) // all look from where the first sees all
  {
    renderer->ResetCamera();
    camera->Zoom(1.05);
  }
  renderer->ResetCameraClippingRange();
}

std::string png_of(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* const bytes = writer->GetResult();
  return std::string(reinterpret_cast<const char*>(bytes->GetPointer(0)), std::size_t(bytes->GetNumberOfValues()));
}

} // namespace

void check_screen()
{
#ifdef __linux__
  if(!std::getenv("DISPLAY"))
    throw Failure("a picture needs a screen: DISPLAY is not set; xvfb-run gives a virtual one");
#endif
}

std::string picture_of(const std::vector<Point>& before, const std::vector<Point>& after, const Polygons& polygons,
                       const std::vector<double>& displacements)
{
  check_screen();
  Drawn_surface original(before, polygons), result(after, polygons), heat(after, polygons);
  const Heat_map map = displacement_map(displacements);
  heat.set_colors(map.colors);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(number_of_panels * panel_width, panel_height);
  vtkNew<vtkCamera> camera;
  aim(camera, original.actor()->GetBounds());
  add_panel(window, 0, original.actor(), camera, "before");
  add_panel(window, 1, result.actor(), camera, "after");
  add_panel(window, 2, heat.actor(), camera, map.legend);
  return png_of(window);
}
