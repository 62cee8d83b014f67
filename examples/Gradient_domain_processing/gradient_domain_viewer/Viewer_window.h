// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_VIEWER_VIEWER_WINDOW_H
#define GRADIENT_DOMAIN_VIEWER_VIEWER_WINDOW_H

#include "Filter_model.h"

#include <QMainWindow>
#include <QTimer>

#include <memory>
#include <string>
#include <vector>

class Control_panel;
class Drawn_surface;
class Surface_view;

// A mesh, the controls beside it and what becomes of the mesh.
class Viewer_window : public QMainWindow
{
  std::unique_ptr<Filter_model> m_model;
  Surface_view* m_view;
  Control_panel* m_panel;
  Drawn_surface* m_surface = nullptr;
  QTimer m_timer; // a slider that runs ahead of the solver is not followed everywhere
  bool m_shows_original = false;

public:
  Viewer_window();
  ~Viewer_window() override;

  // They throw Failure.
  void open(const std::string& path);
  void save(const std::string& path);
  void save_painting();

  void show_original(bool is_original);
  bool is_busy() const { return m_timer.isActive(); }
  const Filter_model* model() const { return m_model.get(); }
  Surface_view& view() { return *m_view; }

protected:
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  void connect_panel();
  void choose_file();
  void choose_output();
  void filter();
  void show_colors();
  void follow_brush();
  template <class Action>
  void guarded(const Action& action);
};

#endif // GRADIENT_DOMAIN_VIEWER_VIEWER_WINDOW_H
