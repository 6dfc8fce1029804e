// SPDX-License-Identifier: GPL-3.0-or-later
// The measuring tool's part of the tools dock.
#pragma once

#include "document/document.h"
#include "tools/measure_tool.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace loopmend {

class MeasureBox : public QWidget {
  Q_OBJECT

 public:
  MeasureBox(const Document& document, MeasureTool& tool, QWidget* parent = nullptr);

 private:
  void show_result();

  const Document& document_;
  MeasureTool& tool_;
  QLabel *distance_, *parts_;
  QPushButton* copy_;
};

}  // namespace loopmend
