// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_VIEWER_CONTROL_PANEL_H
#define GRADIENT_DOMAIN_VIEWER_CONTROL_PANEL_H

#include "Filter_model.h"
#include "Value_slider.h"

#include <QWidget>

#include <functional>

class QComboBox;
class QPlainTextEdit;
class QVBoxLayout;

enum class Coloring { PLAIN, DISPLACEMENT, CURVATURE };

// Whatever can be chosen, and the command line for it.
class Control_panel : public QWidget
{
  QComboBox *m_operation, *m_metric, *m_coloring, *m_brush;
  Value_slider *m_wavelength, *m_scale, *m_curvature_weight, *m_presmoothing, *m_brush_size;
  QPlainTextEdit* m_command;
  QString m_command_text;
  const Filter_model* m_model = nullptr;

public:
  std::function<void()> settings_changed, coloring_changed;
  std::function<void()> open, save, save_painting, wipe_off;

  explicit Control_panel(QWidget* parent);

  // Lengths are those of another mesh.
  void set_model(const Filter_model& model);
  Filter_settings settings() const;
  Coloring coloring() const;
  bool has_brush() const;
  Brush brush() const;
  double brush_radius() const;
  void show_command();

private:
  QComboBox* add_choice(QVBoxLayout* layout, const QString& title, const QString& name, const QStringList& choices);
  Value_slider* add_slider(QVBoxLayout* layout, const QString& title, const QString& name);
  void add_buttons(QVBoxLayout* layout);
  void connect_all();
  void enable();
};

#endif // GRADIENT_DOMAIN_VIEWER_CONTROL_PANEL_H
