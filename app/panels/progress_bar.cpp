// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/progress_bar.h"

#include <QStyleOptionProgressBar>
#include <QStylePainter>

#include <cstdlib>

namespace loopmend {
namespace {

constexpr int interval_ms = 200;
constexpr int highest = 8;           // pixels
constexpr int places = 12;           ///< of the block, from one end to the other
constexpr double block_share = 0.2;  ///< of the width

}  // namespace

ProgressBar::ProgressBar(QWidget* parent) : QProgressBar(parent) {
  setTextVisible(false);
  setMaximumHeight(highest);
  timer_.setInterval(interval_ms);
  connect(&timer_, &QTimer::timeout, this, &ProgressBar::move_on);
}

void ProgressBar::move_on() {
  if (minimum() != maximum()) return;
  place_ = (place_ + 1) % (2 * places);
  update();
}

void ProgressBar::paintEvent(QPaintEvent* event) {
  if (minimum() != maximum()) {
    QProgressBar::paintEvent(event);
    return;
  }
  QStyleOptionProgressBar option;
  initStyleOption(&option);
  option.minimum = 0;
  option.maximum = 1;
  option.progress = 0;
  QStylePainter painter(this);
  painter.drawControl(QStyle::CE_ProgressBar, option);
  option.progress = 1;
  QRect block = rect();
  block.setWidth(static_cast<int>(block_share * width()));
  const int from_left = places - std::abs(places - place_);
  block.moveLeft((width() - block.width()) * from_left / places);
  painter.setClipRect(block);
  painter.drawControl(QStyle::CE_ProgressBar, option);
}

void ProgressBar::showEvent(QShowEvent* event) {
  QProgressBar::showEvent(event);
  timer_.start();
}

void ProgressBar::hideEvent(QHideEvent* event) {
  QProgressBar::hideEvent(event);
  timer_.stop();
}

}  // namespace loopmend
