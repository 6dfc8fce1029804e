// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/progress_box.h"

#include "document/labels.h"
#include "jobs/fill_controller.h"
#include "panels/parts.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace loopmend {

ProgressBox::ProgressBox(const Document& document, FillController& controller, QWidget* parent)
    : QWidget(parent),
      document_(document),
      controller_(controller) {
  build();
  connect(cancel_, &QPushButton::clicked, &controller_, &FillController::cancel);
  connect(&controller_, &FillController::activity_changed, this, &ProgressBox::update_state);
  connect(&controller_, &FillController::stage_changed, this,
          [this](const QString& words) { stage_->setText(words.isEmpty() ? tr("Nothing is running.") : words); });
  connect(&controller_, &FillController::progress_changed, this, [this](int done, int total) {
    bar_->setRange(0, total);
    bar_->setValue(done);
  });
  connect(&document_, &Document::patch_moved, this, &ProgressBox::show_figures);
  connect(&document_, &Document::patches_changed, figures_, &QLabel::clear);
  update_state();
}

void ProgressBox::build() {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2, 0, 2, 0);
  layout->setSpacing(6);
  stage_ = make_note("stage");
  stage_->setText(tr("Nothing is running."));
  bar_ = new QProgressBar;
  bar_->setObjectName(QStringLiteral("progress"));
  bar_->setTextVisible(false);
  bar_->setMaximumHeight(8);
  explain(bar_, tr("Progress"), tr("How far the present job is"));
  QSizePolicy keep = bar_->sizePolicy();
  keep.setRetainSizeWhenHidden(true);
  bar_->setSizePolicy(keep);
  cancel_ = make_button("cancel", tr("Ca&ncel"), tr("Stop at once; what was accepted so far is kept (Esc)"));
  figures_ = make_note("figures");
  figures_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  figures_->setMinimumHeight(4 * fontMetrics().lineSpacing());  // the text changes with every step, the place does not
  layout->addWidget(stage_);
  auto* row = new QHBoxLayout;
  row->addWidget(bar_, 1);
  row->addWidget(cancel_);
  layout->addLayout(row);
  layout->addWidget(figures_);
}

void ProgressBox::update_state() {
  if (!controller_.busy()) figures_->clear();  // the timeline tells about what stands still
  cancel_->setEnabled(controller_.busy());
  bar_->setVisible(controller_.busy());
}

void ProgressBox::show_figures(int patch_id) {
  const OpenPatch* patch = document_.patch(patch_id);
  if (!patch || patch->state->steps == 0) {
    figures_->clear();
    return;
  }
  const PatchState& state = *patch->state;
  QString text = tr("%1, %2: step %3, energy %4 (from %5)")
                     .arg(labels::sentence(labels::holes(document_, {patch->loops.begin(), patch->loops.end()})),
                          labels::flow_name(state.flow))
                     .arg(state.steps)
                     .arg(labels::number(state.energy.final), labels::number(state.energy.initial));
  if (state.last_step.max_move > 0)
    text += tr(", residual %1 edge lengths").arg(labels::number(state.last_step.max_move));
  figures_->setText(text + tr(", %1 s").arg(state.seconds.total, 0, 'f', 1));
}

}  // namespace loopmend
