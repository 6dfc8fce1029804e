// SPDX-License-Identifier: GPL-3.0-or-later
// Language, colours, memory, recovery. Every change counts at once; Cancel is closing and choosing again.
#pragma once

#include "document/preferences.h"

#include <QDialog>

class QComboBox;
class QSpinBox;

namespace loopmend {

class PreferencesDialog : public QDialog {
  Q_OBJECT

 public:
  explicit PreferencesDialog(const Preferences& preferences, QWidget* parent = nullptr);

 Q_SIGNALS:
  void chosen(const Preferences& preferences);

 private:
  void build();
  void show_values();
  void take();

  Preferences preferences_;
  QComboBox *language_ = nullptr, *theme_ = nullptr, *map_ = nullptr;
  QSpinBox *undo_ = nullptr, *timeline_ = nullptr, *autosave_ = nullptr;
  bool syncing_ = false;
};

}  // namespace loopmend
