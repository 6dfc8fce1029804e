// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/progress_box.h"

#include "jobs/fill_controller.h"
#include "panels/parts.h"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

namespace loopmend {
namespace {

constexpr const char* running_part =
    "QProgressBar { border: 1px solid palette(mid); border-radius: 3px; background: palette(base); }"
    "QProgressBar::chunk { background: palette(highlight); width: 48px; }";

}  // namespace

ProgressBox::ProgressBox(FillController& controller, QWidget* parent) : QWidget(parent), controller_(controller) {
  build();
  connect(cancel_, &QPushButton::clicked, &controller_, &FillController::cancel);
  connect(&controller_, &FillController::activity_changed, this, &ProgressBox::update_state);
  connect(&controller_, &FillController::stage_changed, this,
          [this](const QString& words) { stage_->setText(words.isEmpty() ? tr("Nothing is running.") : words); });
  connect(&controller_, &FillController::progress_changed, this, [this](int done, int total) {
    bar_->setRange(0, total);
    bar_->setValue(done);
    // The style fills a bar without an end, which looks as if all was done; a sheet lets a part of it run to and fro.
    bar_->setStyleSheet(total > 0 ? QString() : QString::fromLatin1(running_part));
  });
  update_state();
}

void ProgressBox::build() {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2, 0, 2, 0);
  layout->setSpacing(6);
  stage_ = make_note("stage");
  stage_->setText(tr("Nothing is running."));
  bar_ = new QProgressBar;
  bar_->setTextVisible(false);
  bar_->setMaximumHeight(8);
  explain(bar_, "progress", tr("Progress"), tr("How far the present job is"));
  QSizePolicy keep = bar_->sizePolicy();
  keep.setRetainSizeWhenHidden(true);
  bar_->setSizePolicy(keep);
  cancel_ = make_button("cancel", tr("Cancel"), tr("Stop at once; what was accepted so far is kept (Esc)"));
  auto* row = new QHBoxLayout;
  row->addWidget(stage_, 1);
  row->addWidget(cancel_);
  layout->addLayout(row);
  layout->addWidget(bar_);
}

void ProgressBox::update_state() {
  cancel_->setEnabled(controller_.busy());
  bar_->setVisible(controller_.busy());
}

}  // namespace loopmend
