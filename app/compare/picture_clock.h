// SPDX-License-Identifier: GPL-3.0-or-later
// One clock for several pictures in one window: those that want to be drawn again are drawn one after the other, so that
// the window is put together once for all of them, and none waits longer than another.
#pragma once

#include <QObject>
#include <QTimer>

#include <vector>

namespace loopmend {

class FlowCanvas;

class PictureClock : public QObject {
  Q_OBJECT

 public:
  explicit PictureClock(QObject* parent = nullptr);

  /// Soon; several requests make one picture.
  void request(FlowCanvas* canvas);
  void forget(FlowCanvas* canvas);

 private:
  void draw();

  std::vector<FlowCanvas*> wishes_;
  QTimer timer_{this};
};

}  // namespace loopmend
