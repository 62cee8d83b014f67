// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GRADIENT_DOMAIN_VIEWER_VALUE_SLIDER_H
#define GRADIENT_DOMAIN_VIEWER_VALUE_SLIDER_H

#include <QLabel>
#include <QSlider>
#include <QWidget>

#include <functional>

// A number between two others, with a text that says what it stands for.
class Value_slider : public QWidget
{
public:
  enum class Scale { LINEAR, LOGARITHMIC, LOGARITHMIC_OR_ZERO };

  std::function<void()> changed;                 // by the user or by a script, not by set_range()
  std::function<QString(double)> text_of_value;

  Value_slider(const QString& title, const QString& name, QWidget* parent);

  void set_range(double low, double high, Scale scale, double value);
  double value() const;
  void set_value(double value); // the nearest there is

private:
  static constexpr int steps = 1000;
  QString m_title;
  QLabel* m_label;
  QSlider* m_slider;
  double m_low = 0, m_high = 1;
  Scale m_scale = Scale::LINEAR;

  int position(double value) const;
  void show_text();
};

#endif // GRADIENT_DOMAIN_VIEWER_VALUE_SLIDER_H
