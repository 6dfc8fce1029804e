// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the tools dock on the mirror image of a scan.
#pragma once

#include "jobs/mirror_guide.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;

namespace loopmend {

class MirrorBox : public QWidget {
  Q_OBJECT

 public:
  MirrorBox(const Document& document, MirrorGuide& guide, QWidget* parent = nullptr);

 private:
  void follow();
  QString fits_text() const;

  const Document& document_;
  MirrorGuide& guide_;
  QComboBox* plane_;
  QCheckBox* use_;
  QLabel* fits_;
};

}  // namespace loopmend
