// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/patch_panel.h"

#include "document/document.h"
#include "document/hole_selection.h"
#include "document/targets.h"
#include "jobs/fill_controller.h"
#include "panels/decision_box.h"
#include "panels/fill_box.h"
#include "panels/flow_box.h"
#include "panels/progress_box.h"

#include <QCoreApplication>
#include <QEvent>
#include <QGroupBox>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace loopmend {

namespace {

/// What opens must not make the panel wider.
int width_with_folds(const QWidget& content) {
  constexpr int margins_of_box_and_panel = 40;
  int width = content.minimumSizeHint().width();
  for (const auto* box : content.findChildren<QGroupBox*>())
    for (const auto* fold : box->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
      width = std::max(width, fold->minimumSizeHint().width() + margins_of_box_and_panel);
  return width;
}

/// The least y from `top` on that runs through no visible control.
int first_whole_row(const QWidget& content, int top) {
  for (bool through_one = true; std::exchange(through_one, false);)
    for (const QWidget* control : content.findChildren<QWidget*>()) {
      const bool is_box = !control->findChildren<QWidget*>().empty();
      const int y = control->mapTo(&content, QPoint()).y();
      if (is_box || !control->isVisible() || y >= top || y + control->height() <= top) continue;
      top = y + control->height();
      through_one = true;
    }
  return top;
}

}  // namespace

PatchPanel::PatchPanel(const Document& document, const HoleSelection& selection, FillController& controller,
                       QWidget* parent)
    : QWidget(parent),
      document_(document),
      selection_(selection),
      scroll_(new QScrollArea),
      fill_(new FillBox(document, selection, controller)),
      flow_(new FlowBox(document, selection, controller)),
      decision_(new DecisionBox(document, selection, controller)) {
  setObjectName(QStringLiteral("patchPanel"));
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(8, 2, 8, 2);
  layout->setSpacing(2);
  fill_->add_options(flow_->options_widget());
  flow_->add_states(*decision_);
  layout->addWidget(fill_);
  layout->addWidget(decision_);
  layout->addWidget(flow_);
  layout->addStretch(1);
  scroll_->setWidget(content);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 4);
  whole->setSpacing(4);
  whole->addWidget(scroll_, 1);
  auto* progress = new ProgressBox(controller);
  progress->setContentsMargins(8, 0, 8, 0);
  whole->addWidget(progress);
  setMinimumWidth(width_with_folds(*content) + scroll_->verticalScrollBar()->sizeHint().width() + 2);
  connect(fill_, &FillBox::wanted, &controller,
          [this, &controller](const std::set<int>& loops, const std::set<int>& patch_ids, const FillChoice& choice) {
            controller.fill_and_smooth(loops, patch_ids, choice, flow_->options());
          });
  connect(&controller, &FillController::activity_changed, this, &PatchPanel::update_state);
  connect(&selection, &HoleSelection::selection_changed, this, [this] {
    update_state();
    scroll_to_step();
  });
  connect(&document, &Document::opened, this, &PatchPanel::update_state);
  connect(&document, &Document::scans_changed, this, &PatchPanel::update_state);
  connect(&document, &Document::patches_changed, this, &PatchPanel::update_state);
  connect(&document, &Document::holes_changed, this, &PatchPanel::update_state);
  update_state();
}

/// Controls for patches appear with the first patch, below the others.
void PatchPanel::update_state() {
  const bool any = !document_.patches().empty();
  decision_->setVisible(any);
  flow_->setVisible(any);
  fill_->update_state();
  flow_->update_state();
  decision_->update_state();
  Q_EMIT updated();
}

/// In a low window, to what the selected holes need next: filling, or a decision and the flow. Never under the mouse.
void PatchPanel::scroll_to_step() {
  if (selection_.selected().empty() || underMouse()) return;
  if (!loops_to_fill(document_, selection_).empty() || chosen_patches(document_, selection_).empty()) {
    scroll_->widget()->setMinimumHeight(0);
    scroll_->ensureWidgetVisible(fill_, 0, 0);
    return;
  }
  const int page = scroll_->viewport()->height(), below = flow_->geometry().bottom() + 1 - page;
  const int top = std::min(first_whole_row(*scroll_->widget(), below), decision_->y());
  scroll_->widget()->setMinimumHeight(top > 0 ? top + page : 0);
  QEvent laid_out(QEvent::LayoutRequest);
  QCoreApplication::sendEvent(scroll_, &laid_out);  // gives the content its new height
  scroll_->verticalScrollBar()->setValue(top);
}

}  // namespace loopmend
