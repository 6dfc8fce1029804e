// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/parts.h"

#include <QGuiApplication>
#include <QPushButton>
#include <QScreen>

namespace loopmend {

QPushButton* make_button(const char* name, const QString& text, const QString& help) {
  auto* button = new QPushButton(text);
  button->setObjectName(QLatin1String(name));
  explain(button, QString(text).remove(QLatin1Char('&')), help);
  return button;
}

QuietLabel* make_note(const char* name) {
  auto* label = new QuietLabel;
  label->setObjectName(QLatin1String(name));
  return label;
}

QDialogButtonBox* make_dialog_buttons(QDialogButtonBox::StandardButtons which) {
  auto* buttons = new QDialogButtonBox(which);
  for (QAbstractButton* button : buttons->buttons()) button->setIcon({});
  return buttons;
}

void explain(QWidget* widget, const QString& name, const QString& help) {
  widget->setAccessibleName(name);
  widget->setAccessibleDescription(help);
  widget->setToolTip(help);
}

QSize largest_window() {
  const QSize frame(20, 40);
  return QGuiApplication::primaryScreen()->availableSize() - frame;
}

}  // namespace loopmend
