// Copyright (c) 2026  The Gradient_domain_processing authors.
//
// This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A plugin of CGAL Lab (CGAL 6) and of the Polyhedron demo (CGAL 5): smooths, sharpens and denoises the selected mesh.
// Of a selection item, the faces are the region, and the vertices and the ends of the edges stay where they are.

#include <QtCore/qglobal.h>

#ifdef GRADIENT_DOMAIN_PLUGIN_OF_LAB
#include <CGAL/Three/CGAL_Lab_plugin_helper.h>
#include <CGAL/Three/CGAL_Lab_plugin_interface.h>
#else
#include <CGAL/Three/Polyhedron_demo_plugin_helper.h>
#include <CGAL/Three/Polyhedron_demo_plugin_interface.h>
#endif

#include "Messages_interface.h"
#include "Scene_polyhedron_selection_item.h"
#include "Scene_surface_mesh_item.h"

#include <CGAL/Gradient_domain_processing/denoise.h>
#include <CGAL/Gradient_domain_processing/smooth.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QFormLayout>
#include <QMainWindow>
#include <QPushButton>
#include <QtPlugin>

namespace GDP = CGAL::Gradient_domain_processing;

#ifdef GRADIENT_DOMAIN_PLUGIN_OF_LAB
typedef CGAL::Three::CGAL_Lab_plugin_helper Plugin_helper;
#else
typedef CGAL::Three::Polyhedron_demo_plugin_helper Plugin_helper;
#endif

class Gradient_domain_plugin : public QObject, public Plugin_helper
{
  Q_OBJECT
#ifdef GRADIENT_DOMAIN_PLUGIN_OF_LAB
  Q_INTERFACES(CGAL::Three::CGAL_Lab_plugin_interface)
  Q_PLUGIN_METADATA(IID "com.geometryfactory.CGALLab.PluginInterface/1.0")
#else
  Q_INTERFACES(CGAL::Three::Polyhedron_demo_plugin_interface)
  Q_PLUGIN_METADATA(IID "com.geometryfactory.PolyhedronDemo.PluginInterface/1.0")
#endif

  typedef Scene_surface_mesh_item::Face_graph Mesh;
  typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;

  QAction* m_action = nullptr;
  QDockWidget* m_dock = nullptr;
  Messages_interface* m_messages = nullptr;
  QComboBox *m_operation = nullptr, *m_metric = nullptr;
  QDoubleSpinBox *m_gradient_weight = nullptr, *m_gradient_scale = nullptr, *m_curvature_weight = nullptr;

public:
  void init(QMainWindow* main_window, CGAL::Three::Scene_interface* scene_interface,
            Messages_interface* messages) override
  {
    scene = scene_interface;
    mw = main_window;
    m_messages = messages;
    m_action = new QAction(tr("Gradient-Domain Processing"), mw);
    m_action->setProperty("subMenuName", "Polygon Mesh Processing");
    m_dock = new QDockWidget(tr("Gradient-Domain Processing"), mw);
    m_dock->setVisible(false);
    fill_dock();
    addDockWidget(m_dock);
    connect(m_action, &QAction::triggered, m_dock, [this] {
      m_dock->show();
      m_dock->raise();
    });
  }

  QList<QAction*> actions() const override { return {m_action}; }
  bool applicable(QAction*) const override { return selected_mesh() || selection(); }
  void closure() override { m_dock->hide(); }

private:
  Scene_surface_mesh_item* selected_mesh() const
  {
    return qobject_cast<Scene_surface_mesh_item*>(scene->item(scene->mainSelectionIndex()));
  }
  Scene_polyhedron_selection_item* selection() const
  {
    return qobject_cast<Scene_polyhedron_selection_item*>(scene->item(scene->mainSelectionIndex()));
  }

  void fill_dock()
  {
    QWidget* const panel = new QWidget(m_dock);
    QFormLayout* const form = new QFormLayout(panel);
    const auto number = [&](const QString& title, const QString& help, double value, double largest, int decimals) {
      QDoubleSpinBox* const box = new QDoubleSpinBox(panel);
      box->setDecimals(decimals);
      box->setRange(0, largest);
      box->setValue(value);
      box->setToolTip(help);
      form->addRow(title, box);
      return box;
    };
    const auto choice = [&](const QString& title, const QStringList& choices) {
      QComboBox* const box = new QComboBox(panel);
      box->addItems(choices);
      form->addRow(title, box);
      return box;
    };
    m_operation = choice(tr("Operation"), {tr("smooth"), tr("sharpen"), tr("denoise (chooses its parameters)")});
    m_gradient_weight =
      number(tr("Gradient weight"), tr("1e-6 (fine noise) to 1e-2, in units of the area"), 1e-4, 1, 7);
    m_gradient_scale = number(tr("Scale, to sharpen"), tr("how much steeper the surface gets"), 2, 100, 2);
    m_metric = choice(tr("Metric"), {tr("embedding"), tr("edge aware"), tr("anisotropic"), tr("preserve convex"),
                                     tr("preserve concave")});
    m_curvature_weight = number(tr("Curvature weight"), tr("for all metrics but that of the embedding"), 0.02, 100, 5);
    QPushButton* const apply = new QPushButton(tr("Apply"), panel);
    form->addRow(apply);
    connect(apply, &QPushButton::clicked, this, [this] { apply_to_selected(); });
    m_dock->setWidget(panel);
  }

  template <class... Region>
  GDP::Error_code run(Mesh& mesh, Mesh::Property_map<vertex_descriptor, bool> is_constrained, const Region&... region)
  {
    const auto np = GDP::parameters::vertex_is_constrained_map(is_constrained);
    if(m_operation->currentIndex() == 2)
      return GDP::denoise(region..., mesh, np);
    return GDP::smooth(region..., mesh,
                       np.gradient_weight(m_gradient_weight->value())
                         .gradient_scale(m_operation->currentIndex() == 1 ? m_gradient_scale->value() : 0)
                         .curvature_metric_kind(GDP::Curvature_metric_kind(m_metric->currentIndex()))
                         .curvature_weight(m_curvature_weight->value()));
  }

  GDP::Error_code run_on(Mesh& mesh, const Scene_polyhedron_selection_item* selected)
  {
    auto is_constrained = mesh.add_property_map<vertex_descriptor, bool>("v:gradient_domain_constrained", false).first;
    if(selected)
    {
      for(const auto v : selected->selected_vertices)
        is_constrained[v] = true;
      for(const auto e : selected->selected_edges)
        is_constrained[source(e, mesh)] = is_constrained[target(e, mesh)] = true;
    }
    const bool has_region = selected && !selected->selected_facets.empty();
    const GDP::Error_code code = has_region ? run(mesh, is_constrained, selected->selected_facets)
                                            : run(mesh, is_constrained);
    mesh.remove_property_map(is_constrained);
    return code;
  }

  void apply_to_selected()
  {
    Scene_surface_mesh_item* const item = selected_mesh();
    Scene_polyhedron_selection_item* const selected = selection();
    if(!item && !selected)
    {
      m_messages->message_error(tr("Select a mesh, or a selection of one"));
      return;
    }
    Mesh& mesh = item ? *item->polyhedron() : *selected->polyhedron();
    QApplication::setOverrideCursor(Qt::WaitCursor);
    QElapsedTimer time;
    time.start();
    const GDP::Error_code code = run_on(mesh, selected);
    QApplication::restoreOverrideCursor();
    if(code != GDP::ok)
    {
      m_messages->message_error(QString::fromUtf8(GDP::get_error_message(code)));
      return;
    }
    m_messages->message_information(tr("Gradient-domain processing: %1 ms").arg(time.elapsed()));
    if(item)
    {
      item->invalidateOpenGLBuffers();
      item->itemChanged();
      return;
    }
    selected->poly_item_changed();
    selected->changed_with_poly_item();
  }
};

#include "Gradient_domain_plugin.moc"
