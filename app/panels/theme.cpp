// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/theme.h"

#include <QApplication>
#include <QPalette>

namespace loopmend {

QPalette dark_palette() {
  QPalette p(QColor(66, 71, 79), QColor(47, 51, 57));
  p.setColor(QPalette::Base, QColor(29, 32, 36));
  p.setColor(QPalette::AlternateBase, QColor(44, 47, 52));
  p.setColor(QPalette::ToolTipBase, QColor(62, 66, 73));
  p.setColor(QPalette::ToolTipText, QColor(228, 230, 232));
  p.setColor(QPalette::Highlight, QColor(64, 112, 176));
  p.setColor(QPalette::HighlightedText, QColor(255, 255, 255));
  p.setColor(QPalette::Link, QColor(122, 178, 240));
  for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(role, QColor(228, 230, 232));
  for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, QColor(132, 136, 142));
  p.setColor(QPalette::PlaceholderText, QColor(160, 164, 170));
  return p;
}

QPalette light_palette() {
  QPalette p(QColor(239, 240, 241), QColor(239, 240, 241));
  p.setColor(QPalette::Base, QColor(255, 255, 255));
  p.setColor(QPalette::AlternateBase, QColor(246, 247, 248));
  p.setColor(QPalette::Highlight, QColor(48, 110, 184));
  p.setColor(QPalette::HighlightedText, QColor(255, 255, 255));
  p.setColor(QPalette::Link, QColor(20, 90, 170));
  for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) p.setColor(role, QColor(32, 35, 40));
  for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, QColor(150, 154, 160));
  p.setColor(QPalette::PlaceholderText, QColor(110, 115, 122));
  return p;
}

void apply_theme(Theme theme) {
  static const QPalette system = QApplication::palette();
  static Theme applied = Theme::system;
  if (theme == applied) return;
  applied = theme;
  const QPalette chosen = theme == Theme::dark ? dark_palette() : theme == Theme::light ? light_palette() : system;
  QApplication::setPalette(chosen);
  // The style draws a box in the ground's colour, which is invisible on dark ground.
  QPalette boxes = chosen;
  if (theme == Theme::dark) boxes.setColor(QPalette::Base, QColor(86, 92, 101));
  for (const char* kind : {"QCheckBox", "QRadioButton"}) QApplication::setPalette(boxes, kind);
}

}  // namespace loopmend
