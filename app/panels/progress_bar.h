// SPDX-License-Identifier: GPL-3.0-or-later
// A progress bar that moves a few times a second while it is busy. Where OpenGL runs in software, each change of a widget
// composes the whole window again: the style's own animation, 60 pictures a second, would take a processor from the job.
#pragma once

#include <QProgressBar>
#include <QTimer>

namespace loopmend {

/// Low, without a text. Busy while its range is (0, 0).
class ProgressBar : public QProgressBar {
  Q_OBJECT

 public:
  explicit ProgressBar(QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void move_on();

  QTimer timer_;
  int place_ = 0;  ///< of the block that runs to and fro
};

}  // namespace loopmend
