// SPDX-License-Identifier: GPL-3.0-or-later
// A transparent sheet over the picture on which the tool in hand paints.
#pragma once

#include "tools/view_tool.h"

#include <QPainter>
#include <QWidget>

namespace loopmend {

class ToolSheet : public QWidget {
 public:
  ToolSheet(QWidget* parent, std::function<void(QPainter&)> paint) : QWidget(parent), paint_(std::move(paint)) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setObjectName(QStringLiteral("toolSheet"));
    hide();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paint_(painter);
  }

 private:
  std::function<void(QPainter&)> paint_;
};

}  // namespace loopmend
