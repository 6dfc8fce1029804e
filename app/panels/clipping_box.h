// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses a clipping plane: across what, where, and which side is drawn.
#pragma once

#include "scene/clipping.h"

#include <QGroupBox>

class QCheckBox;
class QComboBox;
class QSlider;

namespace loopmend {

class ClippingBox : public QGroupBox {
  Q_OBJECT

 public:
  explicit ClippingBox(QWidget* parent = nullptr);

  const Clipping& clipping() const { return clipping_; }
  /// Across the line of sight, or off.
  void toggle();
  void turn_off();

 Q_SIGNALS:
  void clipping_changed(const Clipping& clipping);

 private:
  void change();

  Clipping clipping_;
  QComboBox* across_;
  QSlider* place_;
  QCheckBox* near_;
};

}  // namespace loopmend
