// SPDX-License-Identifier: GPL-3.0-or-later
// Below the patch dock, always in sight: what runs, how far it is, and the button that stops it.
#pragma once

#include <QTimer>
#include <QWidget>

#include <functional>
#include <optional>

class QLabel;
class QProgressBar;
class QPushButton;

namespace loopmend {

class FillController;
class SteadyLabel;

class ProgressBox : public QWidget {
  Q_OBJECT

 public:
  explicit ProgressBox(FillController& controller, QWidget* parent = nullptr);

  /// Seconds by which it measures, in place of the clock's: for tests.
  void measure_by(std::function<double()> seconds) { now_ = std::move(seconds); }

 private:
  void build();
  void update_state();
  void estimate(std::optional<double> seconds);
  void show_left();

  FillController& controller_;
  SteadyLabel* stage_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QLabel* left_ = nullptr;
  QPushButton* cancel_ = nullptr;
  std::function<double()> now_;
  double start_ = 0, estimated_ = 0, shown_ = 0;  ///< of the job; the last report; the last one shown
  QTimer each_second_;
  std::optional<double> seconds_left_;  ///< at the last report
};

}  // namespace loopmend
