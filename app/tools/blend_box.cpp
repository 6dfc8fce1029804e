// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/blend_box.h"

#include "document/labels.h"
#include "panels/parts.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

namespace loopmend {

BlendBox::BlendBox(const Document& document, const HoleSelection& selection, PartTool& tool, QWidget* parent)
    : QWidget(parent),
      document_(document),
      selection_(selection),
      tool_(tool),
      chosen_(make_note("blendLoops")),
      facing_(make_button("blendFacing", tr("Those that face each other"),
                          tr("Select of each part the loop that looks at the others most"))),
      density_(new QDoubleSpinBox),
      part_(new QComboBox) {
  auto* hint = make_note(
      "blendHint",
      tr("Select two or more boundaries, in the picture or in the table; Ctrl adds. One patch will join them."));
  density_->setRange(0.1, 10);
  density_->setSingleStep(0.1);
  density_->setValue(1);
  density_->setPrefix(QStringLiteral("\u00d7 "));
  density_->setKeyboardTracking(false);
  explain(density_, "blendDensity", tr("Density"), tr("Edges along a length, relative to the neighborhood"));
  explain(part_, "blendPart", tr("Part to place"),
          tr("This part gets a handle in the picture: arrows move it, rings turn it, the square scales it"));
  auto* form = make_layout<QFormLayout>(this);
  form->setVerticalSpacing(6);
  form->addRow(hint);
  form->addRow(chosen_);
  form->addRow(facing_);
  form->addRow(tr("Density"), density_);
  form->addRow(tr("Place"), part_);
  connect(facing_, &QPushButton::clicked, this, &BlendBox::select_facing_wanted);
  connect(density_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &BlendBox::changed);
  connect(part_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    tool_.set_scan(part_->currentData().toInt());
    Q_EMIT changed();
  });
  connect(&selection_, &HoleSelection::selection_changed, this, &BlendBox::update_state);
  connect(&document_, &Document::scans_changed, this, &BlendBox::follow_scans);
  follow_scans();
}

void BlendBox::follow_scans() {
  const QSignalBlocker quiet(part_);
  part_->clear();
  part_->addItem(tr("no part"), -1);
  for (int index : document_.scans()) part_->addItem(document_.scan(index)->name, index);
  if (tool_.scan() >= 0 && !document_.scan(tool_.scan())) tool_.set_scan(-1);
  part_->setCurrentIndex(std::max(0, part_->findData(tool_.scan())));
  update_state();
}

std::vector<int> BlendBox::loops() const {
  std::vector<int> loops;
  for (int loop : selection_.selected())
    if (document_.present(loop)) loops.push_back(loop);
  return loops;
}

double BlendBox::density() const { return density_->value(); }

QString BlendBox::wanting() const {
  if (!document_.has_scan()) return tr("Open the parts first.");
  for (int loop : loops()) {
    const LoopKind kind = document_.loop(loop).kind;
    if (kind != LoopKind::hole && kind != LoopKind::outer_rim)
      return tr("Only holes and outer rims can be joined, not a loop of the kind: %1.").arg(labels::kind(kind));
    if (document_.patch_of(loop)) return tr("A selected hole is filled: discard its patch first.");
  }
  return loops().size() < 2 ? tr("Select at least two boundaries.") : QString();
}

void BlendBox::update_state() {
  const std::vector<int> chosen = loops();
  chosen_->setText(chosen.empty() ? tr("No boundary is selected.")
                                  : tr("Selected: %1").arg(labels::holes(document_, {chosen.begin(), chosen.end()})));
  facing_->setEnabled(document_.scans().size() > 1);
  part_->setEnabled(document_.scans().size() > 1);
  Q_EMIT changed();
}

}  // namespace loopmend
