// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the tools dock on sharp edges across holes.
#pragma once

#include "jobs/edge_guide.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace loopmend {

class EdgesBox : public QWidget {
  Q_OBJECT

 public:
  explicit EdgesBox(EdgeGuide& guide, QWidget* parent = nullptr);

 private:
  void follow();

  EdgeGuide& guide_;
  QLabel* found_;
  QPushButton* restore_;
};

}  // namespace loopmend
