// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with the scans, defect by defect, each with its count and a button that repairs it.
#pragma once

#include "document/document.h"
#include "jobs/defect_places.h"
#include "jobs/fill_controller.h"
#include "jobs/task_runner.h"

#include <QDialog>

#include <map>
#include <optional>

class QLabel;
class QPushButton;

namespace loopmend {

class SteadyLabel;
class RepairDialog : public QDialog {
  Q_OBJECT

 public:
  RepairDialog(const Document& document, FillController& controller, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// What a repair would remove or change; null: nothing any more.
  void marked(SurfaceShapePtr shape);
  void place_wanted(const DefectPlace& place);

 protected:
  void hideEvent(QHideEvent* event) override;

 private:
  struct Row {
    QLabel* before = nullptr;  ///< the last repair
    QLabel* count = nullptr;
    QPushButton* show = nullptr;
    QPushButton* fix = nullptr;
    std::size_t found = 0;
    std::size_t found_at_start = 0;  ///< of the count that runs
    std::optional<std::size_t> found_before{};
  };
  void build();
  /// Counts again, off the window's thread.
  void count();
  void show_counts(const RepairCounts& counts);
  void add_answer(const QString& words);
  void tell();
  /// Marks it, and goes to its largest place; once more: to the next.
  void show_defect(Defect defect);
  void go_to_next_place();
  void drop_marks();
  void update_buttons();

  const Document& document_;
  FillController& controller_;
  TaskRunner tasks_;
  JobPtr job_, marking_;
  std::optional<Defect> shown_;
  DefectPlaces places_;
  std::size_t next_place_ = 0;
  std::map<Defect, Row> rows_;
  QString done_;  ///< by the last repair, or why it did nothing
  SteadyLabel* summary_ = nullptr;
  QPushButton* all_ = nullptr;
};

}  // namespace loopmend
