// SPDX-License-Identifier: GPL-3.0-or-later
// The bottom dock: the seam before and after in numbers and a sentence, how the run went, H across the seam, a log.
#pragma once

#include "document/patch_state.h"

#include <QTimer>
#include <QWidget>

class QLabel;
class QPlainTextEdit;
class QTableWidget;
class QTabWidget;

namespace loopmend {

class Document;
class EnergyView;
class HoleSelection;
class SectionView;
class SteadyLabel;

class InspectPanel : public QWidget {
  Q_OBJECT

 public:
  InspectPanel(const Document& document, const HoleSelection& selection, QWidget* parent = nullptr);

 public Q_SLOTS:
  void log(const QString& words);
  /// Draws the energy of this patch's run, while it is one of those that the table shows.
  void follow_run(int patch_id);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* build_seam();
  void set_seam_columns();
  QWidget* build_log();
  QWidget* build_curves();
  void update_seam();
  void update_curves(int loop);
  void update_seam_soon();
  void fill_row(int row, int loop);
  std::vector<int> shown_loops() const;
  void copy_seam() const;

  const Document& document_;
  const HoleSelection& selection_;
  QTimer soon_{this};
  int run_ = no_patch;
  QTableWidget* seam_ = nullptr;
  SteadyLabel* sentence_ = nullptr;
  QPlainTextEdit* log_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  EnergyView* energy_ = nullptr;
  QLabel* curve_hole_ = nullptr;
  SectionView* section_ = nullptr;
};

}  // namespace loopmend
