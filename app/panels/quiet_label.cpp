// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/quiet_label.h"

#include <QApplication>
#include <QEvent>
#include <QScopedValueRollback>

namespace loopmend {

QuietLabel::QuietLabel(const QString& text, QWidget* parent) : SteadyLabel(text, parent) { take_colors(); }

void QuietLabel::changeEvent(QEvent* event) {
  SteadyLabel::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && !taking_) take_colors();
}

void QuietLabel::take_colors() {
  constexpr double strength = 0.68;
  const QScopedValueRollback guard(taking_, true);
  const QPalette from = QApplication::palette(this);
  const QColor ink = from.color(QPalette::WindowText), ground = from.color(QPalette::Window);
  const auto mix = [&](int a, int b) { return static_cast<int>(strength * a + (1 - strength) * b); };
  QPalette mine = palette();
  mine.setColor(QPalette::WindowText,
                QColor(mix(ink.red(), ground.red()), mix(ink.green(), ground.green()), mix(ink.blue(), ground.blue())));
  setPalette(mine);
}

}  // namespace loopmend
