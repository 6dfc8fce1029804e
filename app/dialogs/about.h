// SPDX-License-Identifier: GPL-3.0-or-later
// Version, licence, and on whose work this stands.
#pragma once

#include <QDialog>

namespace loopmend {

class About : public QDialog {
  Q_OBJECT

 public:
  explicit About(QWidget* parent = nullptr);
};

}  // namespace loopmend
