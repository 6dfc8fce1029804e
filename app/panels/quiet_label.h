// SPDX-License-Identifier: GPL-3.0-or-later
// Text that explains without shouting: the palette's text colour, moved towards the background.
#pragma once

#include "panels/steady_label.h"

namespace loopmend {

class QuietLabel : public SteadyLabel {
  Q_OBJECT

 public:
  explicit QuietLabel(const QString& text = {}, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void take_colors();
  bool taking_ = false;
};

}  // namespace loopmend
