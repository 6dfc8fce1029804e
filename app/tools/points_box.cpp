// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/points_box.h"

#include "document/labels.h"
#include "panels/parts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QSpinBox>

namespace loopmend {
namespace {

constexpr int fewest = 4;
constexpr std::size_t most_triangles = 4'000'000;

}  // namespace

PointsBox::PointsBox(const Document& document, PointsTool& tool, QWidget* parent)
    : QWidget(parent),
      document_(document),
      tool_(tool),
      scan_(new QComboBox),
      all_(make_option<QRadioButton>("pointsAll", tr("All vertices"), tr("The surface runs through every vertex"))),
      picked_(
          make_option<QRadioButton>("pointsPicked", tr("Only those I pick"),
                                    tr("Click vertices in the picture, or draw a box around them; Ctrl takes away"))),
      clear_(make_button("pointsClear", tr("Clear"), tr("No vertex is picked"))),
      subdivide_(new QSpinBox),
      open_(make_option<QCheckBox>(
          "pointsOpen", tr("Smooth boundaries"),
          tr("For a polyhedron with holes: its boundaries become smooth curves through their vertices"))),
      count_(make_note("pointsCount")),
      size_(make_note("pointsSize")) {
  auto* hint = make_note(
      "pointsHint",
      tr("A smooth surface through the vertices of a polyhedron. Open or drop one; its faces are divided, and "
         "the flow finds the rest."));
  explain(scan_, "pointsScan", tr("Polyhedron"), tr("Which of the open surfaces is meant"));
  all_->setChecked(true);
  subdivide_->setRange(1, 8);
  subdivide_->setValue(3);
  explain(subdivide_, "pointsSubdivide", tr("Subdivisions"), tr("Every one makes four triangles of each"));
  auto* form = make_layout<QFormLayout>(this);
  form->setVerticalSpacing(6);
  form->addRow(hint);
  form->addRow(scan_);
  form->addRow(all_);
  form->addRow(picked_);
  form->addRow(clear_);
  form->addRow(count_);
  form->addRow(tr("Subdivisions"), subdivide_);
  form->addRow(size_);
  form->addRow(open_);
  connect(all_, &QRadioButton::toggled, this,
          [this](bool on) { tool_.set_choice(on ? PointsTool::Choice::all : PointsTool::Choice::picked); });
  connect(clear_, &QPushButton::clicked, &tool_, &PointsTool::clear);
  connect(subdivide_, QOverload<int>::of(&QSpinBox::valueChanged), this, &PointsBox::update_state);
  connect(open_, &QCheckBox::toggled, this, &PointsBox::update_state);
  connect(scan_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { tool_.set_scan(scan_->currentData().toInt()); });
  connect(&tool_, &PointsTool::changed, this, &PointsBox::update_state);
  connect(&document_, &Document::scans_changed, this, &PointsBox::follow_scans);
  follow_scans();
}

void PointsBox::follow_scans() {
  const QSignalBlocker quiet(scan_);
  scan_->clear();
  for (int index : document_.scans()) scan_->addItem(document_.scan(index)->name, index);
  scan_->setCurrentIndex(scan_->findData(tool_.scan()));
  scan_->setVisible(scan_->count() > 1);
  update_state();
}

SubdivisionOptions PointsBox::options() const {
  SubdivisionOptions options;
  options.subdivisions = subdivide_->value();
  options.fixed = tool_.fixed();
  options.boundary = open_->isChecked() ? PolyhedronBoundary::smooth : PolyhedronBoundary::refuse;
  return options;
}

QString PointsBox::wanting() const {
  if (tool_.scan() < 0) return tr("Open a polyhedron first.");
  const auto scan = document_.scan(tool_.scan());
  if (tool_.count() < fewest) return tr("At least 4 vertices have to be picked.");
  if (!scan->loops.empty() && !open_->isChecked())
    return tr("This surface has holes: close them, or let its boundaries become smooth curves.");
  if (scan->model->mesh.n_faces() << (2 * subdivide_->value()) > most_triangles)
    return tr("That would be more than 4 million triangles: fewer subdivisions do.");
  return {};
}

void PointsBox::update_state() {
  const int scan = tool_.scan();
  clear_->setEnabled(picked_->isChecked() && tool_.count() > 0);
  count_->setText(scan < 0 ? QString()
                           : tr("%1 vertices stay").arg(labels::count(static_cast<std::size_t>(tool_.count()))));
  open_->setVisible(scan >= 0 && !document_.scan(scan)->loops.empty());
  size_->setText(
      scan < 0 ? QString()
               : tr("%1 triangles")
                     .arg(labels::count(document_.scan(scan)->model->mesh.n_faces() << (2 * subdivide_->value()))));
  Q_EMIT changed();
}

}  // namespace loopmend
