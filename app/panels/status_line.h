// SPDX-License-Identifier: GPL-3.0-or-later
// The line at the bottom: what runs, and its figures.
#pragma once

#include "document/patch_state.h"

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
  /// Until the next figures; without words, the figures come back.
  void say(const QString& words);
  /// Of the state that the timeline shows, so that both name the same step.
  void show_figures(int patch_id);

 private:
  void count();

  const Document& document_;
  const PrintCheck& check_;
  int patch_ = no_patch;  ///< whose figures are shown; may be gone
  QLabel *stage_, *figures_, *closed_, *scan_;
};

}  // namespace loopmend
