// SPDX-License-Identifier: GPL-3.0-or-later
// Small things that the panels share.
#pragma once

#include "panels/quiet_label.h"

#include <QDialogButtonBox>
#include <QMargins>
#include <QSize>
#include <QString>

class QPushButton;
class QToolButton;
class QWidget;

namespace loopmend {

/// Within the frame of a box in a dock.
inline constexpr QMargins box_margins{8, 4, 8, 6};

/// A push button with a name for tests and a tooltip, which also serves as its description for screen readers.
QPushButton* make_button(const char* name, const QString& text, const QString& help);
/// A quiet label with a name.
QuietLabel* make_note(const char* name, const QString& text = {});
/// Without the style's icons, which are made for a light ground.
QDialogButtonBox* make_dialog_buttons(QDialogButtonBox::StandardButtons which);
/// A button that shows and hides what is rarely needed; hidden at first. The content is put into a layout beside it.
QToolButton* make_fold(const char* name, const QString& title, QWidget* content);
/// Tooltip, and the same words for screen readers.
void explain(QWidget* widget, const QString& title, const QString& help);
/// The same, with a name for tests.
void explain(QWidget* widget, const char* name, const QString& title, const QString& help);
/// Something to tick or to choose, with a name for tests; its text is its title.
template <class Button>
Button* make_option(const char* name, const QString& text, const QString& help) {
  auto* button = new Button(text);
  explain(button, name, QString(text).remove(QLatin1Char('&')), help);
  return button;
}

/// Without margins. @param parent  null: it is put into another layout
template <class Layout>
Layout* make_layout(QWidget* parent = nullptr) {
  auto* layout = parent ? new Layout(parent) : new Layout;
  layout->setContentsMargins(0, 0, 0, 0);
  return layout;
}

/// The largest size of a window that fits the screen with its frame.
QSize largest_window();

}  // namespace loopmend
