// SPDX-License-Identifier: GPL-3.0-or-later
// Where and what to export, and whether it could be printed.
#pragma once

#include "jobs/export_scene.h"
#include "jobs/print_check.h"

#include <QFileDialog>

class QCheckBox;
class QComboBox;
class QLabel;

namespace loopmend {

class ExportDialog : public QFileDialog {
  Q_OBJECT

 public:
  /// @param filters  of the file formats; `filter` is chosen first.
  ExportDialog(PrintCheck& check, const QString& proposal, const QStringList& filters, const QString& filter,
               QWidget* parent = nullptr);

  /// Says that components hidden in the picture are written, too.
  void tell_of_hidden(int count);
  /// @param name  "millimetres"; empty: the unit is not known
  void tell_unit(const QString& name);

  /// Several scans in one file have no labels.
  void leave_out_labels();

  ExportChoice choice() const;
  /// With the format's ending where none was given.
  QString path() const;

 private:
  ExportChoice::Content content() const;
  void show_verdict();
  void follow_format();

  PrintCheck& check_;
  QComboBox* content_;
  QCheckBox *new_faces_, *deviations_;
  bool has_labels_ = true;
  QString unit_;
  QLabel *verdict_, *hidden_;
};

}  // namespace loopmend
