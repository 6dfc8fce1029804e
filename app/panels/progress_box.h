// SPDX-License-Identifier: GPL-3.0-or-later
// Last part of the patch dock: what runs, how far it is, its figures, and the way out.
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace loopmend {

class Document;
class FillController;

class ProgressBox : public QWidget {
  Q_OBJECT

 public:
  ProgressBox(const Document& document, FillController& controller, QWidget* parent = nullptr);

 private:
  void build();
  void update_state();
  void show_figures(int patch_id);

  const Document& document_;
  FillController& controller_;
  QLabel *stage_ = nullptr, *figures_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QPushButton* cancel_ = nullptr;
};

}  // namespace loopmend
