// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the tools dock that cuts a scan by a plane.
#pragma once

#include "jobs/cut_guide.h"
#include "jobs/fill_controller.h"

#include <QWidget>

class QPushButton;

namespace loopmend {

class CutBox : public QWidget {
  Q_OBJECT

 public:
  CutBox(CutGuide& guide, FillController& controller, QWidget* parent = nullptr);

 private:
  void follow();

  CutGuide& guide_;
  FillController& controller_;
  std::vector<QPushButton*> buttons_;
};

}  // namespace loopmend
