// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Value_slider.h"

#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

Value_slider::Value_slider(const QString& title, const QString& name, QWidget* parent)
  : QWidget(parent), m_title(title), m_label(new QLabel(this)), m_slider(new QSlider(Qt::Horizontal, this))
{
  setObjectName(name);
  m_slider->setRange(0, steps);
  m_slider->setAccessibleName(title);
  m_label->setWordWrap(true);
  QVBoxLayout* const layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(m_label);
  layout->addWidget(m_slider);
  QObject::connect(m_slider, &QSlider::valueChanged, this, [this] {
    show_text();
    if(changed)
      changed();
  });
}

void Value_slider::set_range(double low, double high, Scale scale, double value)
{
  m_low = low;
  m_high = high;
  m_scale = scale;
  const QSignalBlocker quiet(m_slider);
  m_slider->setValue(position(value));
  show_text();
}

double Value_slider::value() const
{
  const int position = m_slider->value();
  const double part = double(position) / steps;
  if(m_scale == Scale::LINEAR)
    return m_low + part * (m_high - m_low);
  if(m_scale == Scale::LOGARITHMIC_OR_ZERO && position == 0)
    return 0;
  return m_low * std::pow(m_high / m_low, part);
}

void Value_slider::set_value(double value) { m_slider->setValue(position(value)); }

int Value_slider::position(double value) const
{
  if(m_scale != Scale::LINEAR && !(value > 0))
    return 0;
  const double part = m_scale == Scale::LINEAR ? (value - m_low) / (m_high - m_low)
                                               : std::log(value / m_low) / std::log(m_high / m_low);
  return int(std::lround(steps * (std::min)((std::max)(part, 0.), 1.)));
}

void Value_slider::show_text()
{
  m_label->setText("<b>" + m_title + "</b> " + (text_of_value ? text_of_value(value()) : QString::number(value())));
}
