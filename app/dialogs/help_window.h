// SPDX-License-Identifier: GPL-3.0-or-later
// The help pages, in a window of their own: a list on the left, the page on the right.
#pragma once

#include <QDialog>

class QListWidget;
class QTextBrowser;

namespace loopmend {

class HelpWindow : public QDialog {
  Q_OBJECT

 public:
  explicit HelpWindow(QWidget* parent = nullptr);
  /// @param name  file name in docs/user/window without extension.
  void show_page(const QString& name);
  QString shown_text() const;

 private:
  QListWidget* list_;
  QTextBrowser* page_;
};

}  // namespace loopmend
