// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/picture_clock.h"

#include "compare/flow_canvas.h"
#include "views/picture_pace.h"

#include <QElapsedTimer>

#include <algorithm>
#include <utility>

namespace loopmend {

PictureClock::PictureClock(QObject* parent) : QObject(parent) {
  timer_.setSingleShot(true);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &PictureClock::draw);
}

void PictureClock::request(FlowCanvas* canvas) {
  if (std::find(wishes_.begin(), wishes_.end(), canvas) == wishes_.end()) wishes_.push_back(canvas);
  if (!timer_.isActive()) timer_.start();
}

void PictureClock::forget(FlowCanvas* canvas) { std::erase(wishes_, canvas); }

void PictureClock::draw() {
  QElapsedTimer clock;
  clock.start();
  for (FlowCanvas* canvas : std::exchange(wishes_, {})) canvas->draw();
  timer_.setInterval(wait_after_picture(clock.elapsed()));
  if (!wishes_.empty()) timer_.start();  // with the interval as it is now
}

}  // namespace loopmend
