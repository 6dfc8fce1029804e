// SPDX-License-Identifier: GPL-3.0-or-later
// Below the pictures: the table of the comparison, the energies against the step, H across the seam.
#pragma once

#include "jobs/comparison_controller.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QTableWidget;

namespace loopmend {

class Plot;

class CompareNumbers : public QWidget {
  Q_OBJECT

 public:
  /// @param unit    of lengths; empty: not known
  /// @param filled  has the last row of the table; null: there is none
  CompareNumbers(const ComparisonController& flow_comparison, const QString& unit, ComparedRunPtr filled,
                 QWidget* parent = nullptr);

  /// Everything again.
  void update_all();
  void update_flow_run(int flow_run);
  /// What the lower plot draws.
  enum class Across { curvature, distances };
  void show_across(Across across);
  /// Lies beside the plots, where the window puts it.
  QTableWidget& table() { return *table_; }
  Plot& energies() { return *energies_; }
  Plot& profiles() { return *profiles_; }

 private:
  void update_energies();
  void update_profiles();
  void update_across();
  void update_histogram();
  void fit_width();
  void fill_row(int row, const std::vector<std::string>& cells);

  const ComparisonController& flow_comparison_;
  QString unit_;  ///< "length" where it is not known
  ComparedRunPtr filled_;
  QTableWidget* table_;
  QComboBox* which_;
  Plot *energies_, *profiles_;
  QLabel* across_title_;
  Across across_ = Across::curvature;
};

/// The table as it stands: of the finished comparison, or of what was reached.
std::vector<std::vector<std::string>> table_rows(const ComparisonController& flow_comparison);
/// flow, step, the three energies: a line for each step.
std::string curves_csv(const ComparisonController& flow_comparison);

}  // namespace loopmend
