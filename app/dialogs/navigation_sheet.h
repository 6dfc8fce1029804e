// SPDX-License-Identifier: GPL-3.0-or-later
// A table of what the mouse does in each style of navigation.
#pragma once

#include <QDialog>

namespace loopmend {

class NavigationSheet : public QDialog {
  Q_OBJECT

 public:
  explicit NavigationSheet(QWidget* parent);
};

}  // namespace loopmend
