// SPDX-License-Identifier: GPL-3.0-or-later
// Distances between the compared surfaces, from where they start, or from a mesh in a file.
#include "analysis/surface_distance.h"
#include "compare/compare_numbers.h"
#include "compare/compare_window.h"
#include "compare/flow_view.h"
#include "compare/legend_strip.h"
#include "document/file_path.h"
#include "document/labels.h"
#include "panels/parts.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>

#include <algorithm>

namespace loopmend {
namespace {

/// Entries of the choice that are no flows.
constexpr int mesh_entry = -1, start_entry = -2;

}  // namespace

void CompareWindow::build_from() {
  from_ = new QComboBox;
  explain(from_, "compareFrom", tr("Distance from"),
          tr("The surface that the distances of all views are measured from"));
  for (FlowKind flow : {FlowKind::mmcvf, FlowKind::wf, FlowKind::sdf, FlowKind::mcf})
    from_->addItem(tr("from %1").arg(labels::flow_name(flow)), static_cast<int>(flow));
  from_->addItem(tr("from the start"), start_entry);
  from_->addItem(tr("from a mesh\u2026"), mesh_entry);
}

void CompareWindow::choose_from() {
  if (from_->currentData().toInt() == mesh_entry) {
    const QString path = QFileDialog::getOpenFileName(this, tr("Mesh to measure from"), {},
                                                      tr("Meshes (*.ply *.stl *.obj *.off *.glb *.gltf *.3mf *.vtp "
                                                         "*.vtk *.gz *.PLY *.STL *.OBJ *.OFF);;All files (*)"));
    if (!path.isEmpty()) measure_from_mesh(path);
    if (mesh_.isEmpty()) from_->setCurrentIndex(0);
  }
  measure();
}

void CompareWindow::measure_from_mesh(const QString& path) {
  mesh_ = path;
  from_->setItemText(from_->findData(mesh_entry), tr("from %1").arg(QFileInfo(path).fileName()));
  from_->setCurrentIndex(from_->findData(mesh_entry));
  measure();
}

void CompareWindow::measure() {
  const bool apart = look_.shading == Shading::difference;
  from_->setVisible(apart);
  numbers_->show_across(apart ? CompareNumbers::Across::distances : CompareNumbers::Across::curvature);
  std::optional<DistanceFrom> from;
  if (apart) {
    const int entry = from_->currentData().toInt();
    from.emplace();
    if (entry == start_entry) from->kind = DistanceFrom::Kind::start;
    if (entry == mesh_entry) *from = {DistanceFrom::Kind::mesh, {}, file_path(mesh_)};
    if (entry >= 0) from->flow = static_cast<FlowKind>(entry);
    const QString name = entry == start_entry  ? tr("the start")
                         : entry == mesh_entry ? QFileInfo(mesh_).fileName()
                                               : labels::flow_name(from->flow);
    legend_->set_distance_words(name, task_.unit.isEmpty() ? tr("in the scan's unit") : tr("in %1").arg(task_.unit));
  }
  flow_comparison_.measure_from(from);
}

/// Of all views.
double CompareWindow::range_of_distances() const {
  double widest = 0;
  for (int flow_run = 0; flow_run < flow_comparison_.flow_runs(); ++flow_run) {
    const std::vector<double>& distances = flow_comparison_.flow_run(flow_run)->distances;
    const std::vector<float> values(distances.begin(), distances.end());
    if (summary_of(distances).largest > 0) widest = std::max(widest, symmetric_range(values));
  }
  return widest;
}

}  // namespace loopmend
