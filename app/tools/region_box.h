// SPDX-License-Identifier: GPL-3.0-or-later
// The region's part of the tools dock.
#pragma once

#include "tools/region_tool.h"

#include <QWidget>

class QCheckBox;
class QLabel;
class QPushButton;
class QRadioButton;
class QSlider;

namespace loopmend {

class RegionBox : public QWidget {
  Q_OBJECT

 public:
  explicit RegionBox(RegionTool& tool, QWidget* parent = nullptr);

 Q_SIGNALS:
  void erase_wanted();
  void erase_and_fill_wanted();

 private:
  void update_state();

  RegionTool& tool_;
  QRadioButton *brush_, *lasso_, *add_, *erase_;
  QSlider* radius_;
  QCheckBox* hidden_;
  QLabel *radius_title_, *count_;
  QPushButton *grow_, *shrink_, *clear_, *erase_faces_, *refill_;
};

}  // namespace loopmend
