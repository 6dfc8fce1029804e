#include "panels/theme.h"

#include <QApplication>
#include <QPalette>

namespace loopmend {

QPalette dark_palette() {
  QPalette p(QColor(52, 56, 62), QColor(44, 47, 52));
  p.setColor(QPalette::Base, QColor(34, 37, 41));
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
  switch (theme) {
    case Theme::system: QApplication::setPalette(system); break;
    case Theme::light: QApplication::setPalette(light_palette()); break;
    case Theme::dark: QApplication::setPalette(dark_palette()); break;
  }
}

}  // namespace loopmend
