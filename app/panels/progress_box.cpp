// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/progress_box.h"

#include "document/labels.h"
#include "jobs/fill_controller.h"
#include "jobs/remaining_time.h"
#include "panels/parts.h"
#include "panels/progress_bar.h"

#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

namespace loopmend {

ProgressBox::ProgressBox(FillController& controller, QWidget* parent) : QWidget(parent), controller_(controller) {
  build();
  QElapsedTimer clock;
  clock.start();
  now_ = [clock] { return static_cast<double>(clock.elapsed()) / 1000; };
  connect(cancel_, &QPushButton::clicked, &controller_, &FillController::cancel);
  connect(&controller_, &FillController::activity_changed, this, &ProgressBox::update_state);
  connect(&controller_, &FillController::stage_changed, this,
          [this](const QString& words) { stage_->setText(words.isEmpty() ? tr("Nothing is running.") : words); });
  connect(&controller_, &FillController::progress_changed, this, [this](int done, int total) {
    bar_->setRange(0, total);
    bar_->setValue(done);
  });
  connect(&controller_, &FillController::share_done, this,
          [this](double share) { estimate(seconds_left(now_() - start_, share)); });
  connect(&controller_, &FillController::seconds_left, this, &ProgressBox::estimate);
  each_second_.setInterval(1000);
  connect(&each_second_, &QTimer::timeout, this, &ProgressBox::show_left);
  update_state();
}

void ProgressBox::build() {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2, 0, 2, 0);
  layout->setSpacing(6);
  stage_ = make_note("stage");
  stage_->setText(tr("Nothing is running."));
  stage_->keep_room_for({QStringLiteral("1\n2")});  // Cancel stays in its place
  bar_ = new ProgressBar;
  explain(bar_, "progress", tr("Progress"), tr("How far the present job is"));
  QSizePolicy keep = bar_->sizePolicy();
  keep.setRetainSizeWhenHidden(true);
  bar_->setSizePolicy(keep);
  cancel_ = make_button("cancel", tr("Cancel"), tr("Stop at once; what was accepted so far is kept (Esc)"));
  auto* row = new QHBoxLayout;
  row->addWidget(stage_, 1);
  row->addWidget(cancel_);
  layout->addLayout(row);
  left_ = make_note("timeLeft");
  left_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  left_->setMinimumWidth(left_->fontMetrics().horizontalAdvance(labels::time_left(99 * 60)));
  left_->setFixedHeight(
      left_->fontMetrics().lineSpacing());  // with and without text, so that Cancel stays in its place
  auto* below = new QHBoxLayout;
  below->addWidget(bar_, 1);
  below->addWidget(left_);
  layout->addLayout(below);
}

void ProgressBox::update_state() {
  cancel_->setEnabled(controller_.busy());
  bar_->setVisible(controller_.busy());
  if (controller_.busy() == each_second_.isActive()) return;
  seconds_left_.reset();
  if (controller_.busy()) {
    start_ = now_();
    each_second_.start();
  } else {
    each_second_.stop();
  }
  show_left();
}

void ProgressBox::estimate(std::optional<double> seconds) {
  seconds_left_ = seconds;
  estimated_ = now_();
  if (estimated_ - shown_ < 1) return;  // a text that changes with each small hole cannot be read
  shown_ = estimated_;
  show_left();
}

/// Counts down between two reports. Nothing at first, and once the estimate has run out.
void ProgressBox::show_left() {
  const bool known = seconds_left_ && now_() - start_ >= least_seconds_shown;
  left_->setText(labels::time_left(known ? *seconds_left_ - (now_() - estimated_) : 0));
}

}  // namespace loopmend
