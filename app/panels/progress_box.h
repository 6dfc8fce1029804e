// SPDX-License-Identifier: GPL-3.0-or-later
// Below the patch dock, always in sight: what runs, how far it is, and the button that stops it.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <optional>

class QLabel;
class QProgressBar;
class QPushButton;

namespace loopmend {

class FillController;

class ProgressBox : public QWidget {
  Q_OBJECT

 public:
  explicit ProgressBox(FillController& controller, QWidget* parent = nullptr);

 private:
  void build();
  void update_state();
  void show_left();

  FillController& controller_;
  QLabel* stage_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QLabel* left_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QElapsedTimer since_start_, since_estimate_;
  QTimer each_second_;
  std::optional<double> seconds_left_;  ///< at the last report
};

}  // namespace loopmend
