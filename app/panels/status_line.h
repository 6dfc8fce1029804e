// SPDX-License-Identifier: GPL-3.0-or-later
// The line at the bottom: what runs, and its figures.
#pragma once

#include <QWidget>

class QLabel;

namespace loopmend {

class Document;
class FillController;
class PrintCheck;

class StatusLine : public QWidget {
  Q_OBJECT

 public:
  StatusLine(const Document& document, const FillController& controller, const PrintCheck& check,
             QWidget* parent = nullptr);

 public Q_SLOTS:
  /// Until the next figures.
  void say(const QString& words);

 private:
  void update_scan();
  void count();
  void show_figures(int patch_id);

  const Document& document_;
  const PrintCheck& check_;
  QLabel *stage_, *figures_, *closed_, *scan_;
};

}  // namespace loopmend
