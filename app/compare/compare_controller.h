// SPDX-License-Identifier: GPL-3.0-or-later
// Opens comparisons, and keeps each alive until its workers have ended.
#pragma once

#include "compare/compare_window.h"
#include "document/hole_selection.h"
#include "jobs/fill_controller.h"
#include "jobs/problem_controller.h"

#include <QPointer>
#include <QTimer>

#include <memory>
#include <vector>

namespace loopmend {

class CompareController : public QObject {
  Q_OBJECT

 public:
  CompareController(const Document& document, const HoleSelection& selection, FillController& controller,
                    QWidget* window);

  /// The loops that compare_holes() would take: the selected ones, or all holes; all of one scan.
  std::set<int> loops() const;
  /// The flows from the first patch of these holes, in the window that shows them where there is one. Says why not where that is
  /// impossible.
  CompareWindow* compare_holes(const Look& look);
  /// The flows on what a tool has posed.
  CompareWindow* compare_trial(ProblemController& trial, const Look& look);
  CompareWindow* compare(CompareTask task, const Look& look);
  /// A comparison opens beside this part of the main window where the screen is wide enough.
  void keep_in_sight(const QWidget* part) { in_sight_ = part; }
  /// @returns whether every worker has ended.
  bool shut_down(std::chrono::milliseconds at_most);

 Q_SIGNALS:
  void opened(CompareWindow* window);
  void failed(const QString& words);

 private:
  void place(CompareWindow& window) const;
  void bury();

  const Document& document_;
  const HoleSelection& selection_;
  FillController& controller_;
  QWidget* window_;
  QPointer<const QWidget> in_sight_;
  std::vector<std::unique_ptr<ComparisonController>>
      closed_;  ///< their windows are gone, their workers perhaps not yet
  std::vector<std::pair<QPointer<CompareWindow>, std::unique_ptr<ComparisonController>>> open_;
  /// What a window compares flows on.
  struct OfHoles {
    QPointer<CompareWindow> window;
    ModelPtr model;
    std::set<int> loops;
    double density;
    PatchStatePtr filled;  ///< when it was opened
  };
  std::vector<OfHoles> of_holes_;
  QTimer undertaker_;
};

}  // namespace loopmend
