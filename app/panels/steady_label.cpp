// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/steady_label.h"

#include <algorithm>

namespace loopmend {

SteadyLabel::SteadyLabel(const QString& text, QWidget* parent) : QLabel(text, parent) { setWordWrap(true); }

void SteadyLabel::keep_room_for(const QStringList& texts) {
  texts_ = texts;
  updateGeometry();
}

int SteadyLabel::heightForWidth(int width) const {
  int height = QLabel::heightForWidth(width);
  for (const QString& text : texts_) {
    QLabel other(text);
    other.setFont(font());
    other.setWordWrap(true);
    other.setMargin(margin());
    other.setTextInteractionFlags(textInteractionFlags());  // these have other margins
    height = std::max(height, other.heightForWidth(width));
  }
  return height;
}

}  // namespace loopmend
