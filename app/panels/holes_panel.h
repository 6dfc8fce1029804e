// SPDX-License-Identifier: GPL-3.0-or-later
// The left dock: every boundary loop as a row; rows and loops in the view light up together.
#pragma once

#include "document/hole_selection.h"

#include <QWidget>

#include <set>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;

namespace loopmend {

class Document;
class HoleFilter;
class HoleSelection;
class HoleTable;
class SmallHolesBox;

class HolesPanel : public QWidget {
  Q_OBJECT

 public:
  HolesPanel(Document& document, HoleSelection& selection, QWidget* parent = nullptr);

  enum class Way { next, previous, next_to_look_at };
  /// Selects the next loop of the table, and flies there.
  void go(Way way);
  void focus_filter();
  void select_all_holes();
  SmallHolesBox& small_holes() { return *small_; }

 Q_SIGNALS:
  void fly_to(int loop);
  void fill_wanted(const std::set<int>& loops);
  /// A right click on a row, which is selected now. @param at  of the screen
  void hole_menu_wanted(const QPoint& at);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* build_filter();
  void build_table();
  void take_selection();
  void show_selection();
  void show_hover();
  void paint_row(int loop);
  void fit_columns();
  void fit_state_column();
  void update_summary();
  void show_column_menu(const QPoint& at);
  int loop_at(const QModelIndex& proxy_index) const;

  Document& document_;
  HoleSelection& selection_;
  HoleTable* model_;
  HoleFilter* sorted_;
  QTableView* table_;
  QLineEdit* words_ = nullptr;
  QComboBox* group_ = nullptr;
  QLabel* summary_;
  QPushButton* all_;
  QPushButton* next_;
  QToolButton* fold_ = nullptr;
  SmallHolesBox* small_;
  int lit_ = no_loop;     ///< its row is painted as the one under the mouse
  bool several_ = false;  ///< scans are open
  bool syncing_ = false;
};

}  // namespace loopmend
