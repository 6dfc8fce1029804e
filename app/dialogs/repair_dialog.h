// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with the scans, defect by defect, each with its count and a button that repairs it.
#pragma once

#include "document/document.h"
#include "jobs/fill_controller.h"
#include "jobs/task_runner.h"

#include <QDialog>

#include <map>

class QLabel;
class QPushButton;

namespace loopmend {

class SteadyLabel;
class RepairDialog : public QDialog {
  Q_OBJECT

 public:
  RepairDialog(const Document& document, FillController& controller, QWidget* parent = nullptr);

 private:
  struct Row {
    QLabel* count = nullptr;
    QPushButton* fix = nullptr;
    std::size_t found = 0;
  };
  void build();
  /// Counts again, off the window's thread.
  void count();
  void show_counts(const RepairCounts& counts);
  void tell();
  void update_buttons();

  const Document& document_;
  FillController& controller_;
  TaskRunner tasks_;
  JobPtr job_;
  std::map<Defect, Row> rows_;
  QString done_;  ///< by the last repair
  SteadyLabel* summary_ = nullptr;
  QPushButton* all_ = nullptr;
};

}  // namespace loopmend
