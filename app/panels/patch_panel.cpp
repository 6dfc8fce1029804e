// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/patch_panel.h"

#include "document/hole_selection.h"
#include "jobs/fill_controller.h"
#include "panels/decision_box.h"
#include "panels/fill_box.h"
#include "panels/flow_box.h"
#include "panels/progress_box.h"

#include <QVBoxLayout>

namespace loopmend {

PatchPanel::PatchPanel(const Document& document, const HoleSelection& selection, FillController& controller,
                       QWidget* parent)
    : QScrollArea(parent),
      fill_(new FillBox(document, selection, controller)),
      flow_(new FlowBox(document, selection, controller)),
      decision_(new DecisionBox(document, selection, controller)) {
  setObjectName(QStringLiteral("patchPanel"));
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(8, 6, 8, 8);
  layout->setSpacing(8);
  layout->addWidget(fill_);
  layout->addWidget(flow_);
  layout->addWidget(decision_);
  layout->addWidget(new ProgressBox(document, controller));
  layout->addStretch(1);
  setWidget(content);
  setMinimumWidth(content->minimumSizeHint().width() + 2);
  connect(&controller, &FillController::activity_changed, this, &PatchPanel::update_state);
  connect(&selection, &HoleSelection::selection_changed, this, &PatchPanel::update_state);
  connect(&document, &Document::opened, this, &PatchPanel::update_state);
  connect(&document, &Document::scans_changed, this, &PatchPanel::update_state);
  connect(&document, &Document::patches_changed, this, &PatchPanel::update_state);
  connect(&document, &Document::holes_changed, this, &PatchPanel::update_state);
  update_state();
}

void PatchPanel::update_state() {
  fill_->update_state();
  flow_->update_state();
  decision_->update_state();
  Q_EMIT updated();
}

}  // namespace loopmend
