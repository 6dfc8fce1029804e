// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/parts.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QTimer>
#include <QToolButton>

namespace loopmend {

QPushButton* make_button(const char* name, const QString& text, const QString& help) {
  auto* button = new QPushButton(text);
  button->setObjectName(QLatin1String(name));
  explain(button, QString(text).remove(QLatin1Char('&')), help);
  return button;
}

QuietLabel* make_note(const char* name, const QString& text) {
  auto* label = new QuietLabel(text);
  label->setObjectName(QLatin1String(name));
  return label;
}

QDialogButtonBox* make_dialog_buttons(QDialogButtonBox::StandardButtons which) {
  auto* buttons = new QDialogButtonBox(which);
  for (QAbstractButton* button : buttons->buttons()) button->setIcon({});
  return buttons;
}

QToolButton* make_fold(const char* name, const QString& title, QWidget* content) {
  auto* button = new QToolButton;
  button->setObjectName(QLatin1String(name));
  button->setText(title);
  explain(button, title, QCoreApplication::translate("loopmend", "Show or hide what is rarely needed"));
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setArrowType(Qt::RightArrow);
  button->setAutoRaise(true);
  button->setCheckable(true);
  button->setFocusPolicy(Qt::StrongFocus);
  content->setObjectName(QLatin1String(name) + QStringLiteral("Content"));
  content->hide();
  QObject::connect(button, &QToolButton::toggled, content, [button, content](bool open) {
    button->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    content->setVisible(open);
    if (!open) return;
    QTimer::singleShot(0, content, [button, content] {  // when it has its place
      for (QWidget* above = content->parentWidget(); above; above = above->parentWidget())
        if (auto* area = qobject_cast<QScrollArea*>(above))
          for (QWidget* seen : {static_cast<QWidget*>(button), content}) area->ensureWidgetVisible(seen, 0, 0);
    });
  });
  return button;
}

void explain(QWidget* widget, const QString& title, const QString& help) {
  widget->setAccessibleName(title);
  widget->setAccessibleDescription(help);
  widget->setToolTip(help);
}

void explain(QWidget* widget, const char* name, const QString& title, const QString& help) {
  widget->setObjectName(QLatin1String(name));
  explain(widget, title, help);
}

QSize largest_window() {
  const QSize frame(20, 40);
  return QGuiApplication::primaryScreen()->availableSize() - frame;
}

}  // namespace loopmend
