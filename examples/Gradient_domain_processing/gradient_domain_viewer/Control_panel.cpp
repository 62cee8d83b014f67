// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Control_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace GDP = CGAL::Gradient_domain_processing;

namespace {

const QStringList operations = {"filter", "enhance-details", "denoise"};
const QStringList metrics = {"embedding", "edge-aware", "anisotropic", "preserve-convex", "preserve-concave"};
const QStringList colorings = {"none", "displacement", "curvature"};
const QStringList brushes = {"none (turn the view)", "region", "constrained", "mask"};
constexpr Operation operation_of[] = {Operation::FILTER, Operation::ENHANCE_DETAILS, Operation::DENOISE};

QString digits(double x) { return QString::number(x, 'g', 3); }

} // namespace

Control_panel::Control_panel(QWidget* parent) : QWidget(parent)
{
  QVBoxLayout* const layout = new QVBoxLayout(this);
  m_operation = add_choice(layout, "Operation", "operation", operations);
  m_wavelength = add_slider(layout, "Wavelength", "wavelength");
  m_scale = add_slider(layout, "Scale of gradients", "scale");
  m_metric = add_choice(layout, "Metric", "metric", metrics);
  m_curvature_weight = add_slider(layout, "Bends", "curvature-weight");
  m_presmoothing = add_slider(layout, "Presmoothing", "presmoothing");
  m_coloring = add_choice(layout, "Colors", "colors", colorings);
  m_brush = add_choice(layout, "Brush", "brush", brushes);
  m_brush_size = add_slider(layout, "Size", "brush-size");
  add_buttons(layout);
  QLabel* const help = new QLabel("Hold the space bar to see the original. A brush paints with the left button, "
                                  "Shift wipes off.", this);
  help->setWordWrap(true);
  layout->addWidget(help);
  layout->addWidget(new QLabel("<b>The same on the command line</b>", this));
  m_command = new QPlainTextEdit(this);
  m_command->setObjectName("command");
  m_command->setReadOnly(true);
  m_command->setFocusPolicy(Qt::ClickFocus);
  m_command->setLineWrapMode(QPlainTextEdit::NoWrap);
  layout->addWidget(m_command, 1);
  setFixedWidth(340);
  connect_all();
}

QComboBox* Control_panel::add_choice(QVBoxLayout* layout, const QString& title, const QString& name,
                                     const QStringList& choices)
{
  QComboBox* const box = new QComboBox(this);
  box->setObjectName(name);
  box->setAccessibleName(title);
  box->addItems(choices);
  QHBoxLayout* const row = new QHBoxLayout;
  row->addWidget(new QLabel("<b>" + title + "</b>", this));
  row->addWidget(box, 1);
  layout->addLayout(row);
  return box;
}

Value_slider* Control_panel::add_slider(QVBoxLayout* layout, const QString& title, const QString& name)
{
  Value_slider* const slider = new Value_slider(title, name, this);
  layout->addWidget(slider);
  return slider;
}

void Control_panel::add_buttons(QVBoxLayout* layout)
{
  QGridLayout* const grid = new QGridLayout;
  int place = 0;
  const auto add = [&](const QString& text, const QString& name, const auto& action) {
    QPushButton* const button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setFocusPolicy(Qt::TabFocus); // the space bar is for the original
    grid->addWidget(button, place / 3, place % 3);
    ++place;
    QObject::connect(button, &QPushButton::clicked, this, action);
  };
  add("Open ...", "open", [this] { open(); });
  add("Save ...", "save", [this] { save(); });
  add("Copy command", "copy", [this] { QApplication::clipboard()->setText(m_command_text); });
  add("Save paint", "save-paint", [this] { save_painting(); });
  add("Wipe all off", "wipe-off", [this] { wipe_off(); });
  layout->addLayout(grid);
}

void Control_panel::connect_all()
{
  const auto tell = [this] {
    enable();
    if(m_model && settings_changed)
      settings_changed();
  };
  for(QComboBox* box : {m_operation, m_metric})
    QObject::connect(box, &QComboBox::currentTextChanged, this, tell);
  for(Value_slider* slider : {m_wavelength, m_scale, m_curvature_weight, m_presmoothing})
    slider->changed = tell;
  for(QComboBox* box : {m_coloring, m_brush})
    QObject::connect(box, &QComboBox::currentTextChanged, this, [this] {
      if(m_model && coloring_changed)
        coloring_changed();
    });
  const auto length = [this](double x) {
    const Wavelengths& lengths = m_model->wavelengths();
    return digits(x) + " = " + digits(x / lengths.mean_edge()) + " edges";
  };
  m_wavelength->text_of_value = [=](double x) {
    return !m_model ? QString() : length(x) + " (weight " + digits(settings().gradient_weight) + "): shorter waves are "
           "changed by more than half of what the scale says";
  };
  m_scale->text_of_value = [](double x) {
    return digits(x) + (x < 1 ? ": smooths" : x > 1 ? ": sharpens" : ": nothing changes");
  };
  m_curvature_weight->text_of_value = [this](double x) {
    return m_model ? digits(x) + ": radii below " + digits(m_model->wavelengths().radius(x)) + " are kept" : QString();
  };
  m_presmoothing->text_of_value = [=](double x) {
    return !m_model ? QString() : x == 0 ? QString("none") : length(x) + ", before curvature is estimated";
  };
  m_brush_size->text_of_value = [=](double x) { return m_model ? length(x) : QString(); };
}

void Control_panel::set_model(const Filter_model& model)
{
  m_model = &model;
  const Wavelengths& lengths = model.wavelengths();
  const Filter_settings start;
  typedef Value_slider::Scale Scale;
  const double shortest = lengths.mean_edge() / 2, longest = 2 * lengths.diagonal();
  m_wavelength->set_range(shortest, longest, Scale::LOGARITHMIC, lengths.wavelength(start.gradient_weight));
  m_scale->set_range(0, 10, Scale::LINEAR, start.gradient_scale);
  m_curvature_weight->set_range(1e-5, 10, Scale::LOGARITHMIC, start.curvature_weight);
  m_presmoothing->set_range(shortest, longest, Scale::LOGARITHMIC_OR_ZERO,
                            lengths.wavelength(start.presmoothing_weight));
  m_brush_size->set_range(lengths.mean_edge(), lengths.diagonal() / 2, Scale::LOGARITHMIC, lengths.diagonal() / 20);
  enable();
}

// What has no effect cannot be moved.
void Control_panel::enable()
{
  const Operation operation = operation_of[m_operation->currentIndex()];
  m_wavelength->setEnabled(operation != Operation::DENOISE);
  m_scale->setEnabled(operation == Operation::FILTER);
  m_metric->setEnabled(operation != Operation::DENOISE);
  const bool has_metric = operation != Operation::DENOISE && m_metric->currentIndex() > 0;
  m_curvature_weight->setEnabled(has_metric);
  m_presmoothing->setEnabled(has_metric);
}

Filter_settings Control_panel::settings() const
{
  const Wavelengths& lengths = m_model->wavelengths();
  Filter_settings settings;
  settings.operation = operation_of[m_operation->currentIndex()];
  settings.gradient_weight = rounded(lengths.weight(m_wavelength->value()));
  settings.gradient_scale = rounded(m_scale->value());
  settings.metric = GDP::Curvature_metric_kind(m_metric->currentIndex());
  settings.curvature_weight = rounded(m_curvature_weight->value());
  settings.presmoothing_weight = rounded(lengths.weight(m_presmoothing->value()));
  return settings;
}

Coloring Control_panel::coloring() const { return Coloring(m_coloring->currentIndex()); }

bool Control_panel::has_brush() const { return m_brush->currentIndex() > 0; }

Brush Control_panel::brush() const { return Brush(m_brush->currentIndex() - 1); }

double Control_panel::brush_radius() const { return m_brush_size->value(); }

void Control_panel::show_command()
{
  m_command_text = QString::fromStdString(m_model->command("result.ply"));
  m_command->setPlainText(m_command_text + (m_model->is_painting_saved() ? "" : "\n\n(after \"Save paint\")"));
}
