// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Viewer_window.h"
#include "Control_panel.h"
#include "Surface_view.h"
#include "heat_map.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QStatusBar>

#include <exception>

namespace {

constexpr Rgb brush_colors[number_of_brushes] = {{{60, 150, 60}}, {{30, 30, 30}}, {{150, 80, 180}}};
const char* const file_kinds = "Meshes (*.ply *.obj *.off *.stl *.ply.gz *.obj.gz *.off.gz *.stl.gz)";

} // namespace

// What goes wrong is said, and all is as it was.
template <class Action>
void Viewer_window::guarded(const Action& action)
{
  try
  {
    action();
  }
  catch(const std::exception& error)
  {
    statusBar()->showMessage(QString::fromStdString(error.what()));
  }
}

Viewer_window::Viewer_window()
{
  setWindowTitle("gradient_domain_viewer");
  QWidget* const center = new QWidget(this);
  QHBoxLayout* const layout = new QHBoxLayout(center);
  m_view = new Surface_view(center);
  m_panel = new Control_panel(center);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_view, 1);
  layout->addWidget(m_panel);
  setCentralWidget(center);
  resize(1180, 800);
  m_timer.setSingleShot(true);
  QObject::connect(&m_timer, &QTimer::timeout, this, [this] { filter(); });
  connect_panel();
  qApp->installEventFilter(this);
  statusBar()->showMessage("Open a mesh: PLY, OBJ, OFF or STL");
}

Viewer_window::~Viewer_window() = default;

void Viewer_window::connect_panel()
{
  m_panel->settings_changed = [this] { m_timer.start(0); };
  m_panel->coloring_changed = [this] {
    guarded([&] { show_colors(); });
    follow_brush();
  };
  m_panel->open = [this] { guarded([&] { choose_file(); }); };
  m_panel->save = [this] { guarded([&] { choose_output(); }); };
  m_panel->save_painting = [this] {
    if(m_model)
      guarded([&] { save_painting(); });
  };
  m_panel->wipe_off = [this] {
    if(!m_model)
      return;
    m_model->wipe_off();
    m_timer.start(0);
  };
  m_view->stroke_ends = [this] { m_timer.start(0); };
}

void Viewer_window::open(const std::string& path)
{
  m_model = std::make_unique<Filter_model>(path); // the old one stays if this fails
  setWindowTitle(QString::fromStdString(path) + " - gradient_domain_viewer");
  m_surface = &m_view->show_surface(m_model->original_points(), m_model->polygons());
  m_panel->set_model(*m_model);
  m_timer.start(0);
}

void Viewer_window::choose_file()
{
  const QString path = QFileDialog::getOpenFileName(this, "Open a mesh", QString(), file_kinds);
  if(!path.isEmpty())
    open(path.toStdString());
}

void Viewer_window::choose_output()
{
  if(!m_model)
    return;
  const QString path = QFileDialog::getSaveFileName(this, "Save the result", QString(), file_kinds);
  if(!path.isEmpty())
    save(path.toStdString());
}

void Viewer_window::save(const std::string& path)
{
  std::string message = "Saved " + path;
  for(const std::string& sentence : m_model->save(path))
    message += "; " + sentence;
  statusBar()->showMessage(QString::fromStdString(message));
}

void Viewer_window::save_painting()
{
  m_model->save_painting();
  m_panel->show_command();
  statusBar()->showMessage("Saved " + QString::fromStdString(m_model->painting_path()));
}

void Viewer_window::filter()
{
  if(!m_model)
    return;
  QElapsedTimer clock;
  clock.start();
  guarded([&] {
    statusBar()->clearMessage();
    m_model->set(m_panel->settings());
    const double milliseconds = double(clock.nsecsElapsed()) * 1e-6;
    show_colors();
    if(!m_model->why_unchanged().empty())
      statusBar()->showMessage("Nothing has changed: " + QString::fromStdString(m_model->why_unchanged()));
    else if(m_panel->coloring() == Coloring::PLAIN)
      statusBar()->showMessage(QString("%1 vertices, %2 faces; filtered in %3 ms")
                                 .arg(m_model->points().size())
                                 .arg(m_model->polygons().size())
                                 .arg(milliseconds, 0, 'f', 1));
  });
  m_panel->show_command();
}

void Viewer_window::show_original(bool is_original)
{
  if(m_shows_original == is_original || !m_model)
    return;
  m_shows_original = is_original;
  guarded([&] { show_colors(); });
}

// The points and their colors, which tell of the points that are shown.
void Viewer_window::show_colors()
{
  if(!m_model)
    return;
  const std::vector<Point>& points = m_shows_original ? m_model->original_points() : m_model->points();
  Heat_map map;
  if(m_panel->coloring() == Coloring::CURVATURE)
    map = curvature_map(m_model->curvatures(points));
  else if(m_panel->coloring() == Coloring::DISPLACEMENT && !m_shows_original)
    map = displacement_map(m_model->displacements());
  else
    map.colors.assign(points.size(), clay);
  const Painting& painting = m_model->painting();
  for(Brush brush : {Brush::REGION, Brush::MASK, Brush::CONSTRAINED})
    for(std::size_t v = 0; v < points.size() && painting.has(brush) && !m_shows_original; ++v)
      if(painting.is_painted(brush, v))
        map.colors[v] = mixed(map.colors[v], brush_colors[std::size_t(brush)], 0.4);
  m_surface->set_points(points);
  m_surface->set_colors(map.colors);
  if(!map.legend.empty())
    statusBar()->showMessage(QString::fromStdString(map.legend));
  m_view->draw();
}

void Viewer_window::follow_brush()
{
  m_view->dab = nullptr;
  if(m_model && m_panel->has_brush())
    m_view->dab = [this](const Point& center, bool is_painted) {
      if(m_model->paint(m_panel->brush(), center, m_panel->brush_radius(), is_painted))
        show_colors();
    };
}

bool Viewer_window::eventFilter(QObject* object, QEvent* event)
{
  const bool is_press = event->type() == QEvent::KeyPress, is_release = event->type() == QEvent::KeyRelease;
  if((!is_press && !is_release) || !isActiveWindow() || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Space)
    return QMainWindow::eventFilter(object, event);
  if(!static_cast<QKeyEvent*>(event)->isAutoRepeat())
    show_original(is_press);
  return true;
}
