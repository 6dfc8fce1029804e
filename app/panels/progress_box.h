// SPDX-License-Identifier: GPL-3.0-or-later
// Below the patch dock, always in sight: what runs, how far it is, and the way out.
#pragma once

#include <QWidget>

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

  FillController& controller_;
  QLabel* stage_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QPushButton* cancel_ = nullptr;
};

}  // namespace loopmend
