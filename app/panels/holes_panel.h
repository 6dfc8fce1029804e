// The left dock: every boundary loop as a row; rows and loops in the view light up together.
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace loopmend {

class Document;
class HoleSelection;
class HoleTable;

class HolesPanel : public QWidget {
  Q_OBJECT

 public:
  HolesPanel(const Document& document, HoleSelection& selection, QWidget* parent = nullptr);

 Q_SIGNALS:
  void fly_to(int loop);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void build_table();
  void take_selection();
  void show_selection();
  void show_hover();
  void fit_columns();
  void on_opened();
  void update_summary();
  void select_all_holes();
  int loop_at(const QModelIndex& proxy_index) const;

  const Document& document_;
  HoleSelection& selection_;
  HoleTable* model_;
  QSortFilterProxyModel* sorted_;
  QTableView* table_;
  QLabel* summary_;
  QPushButton* all_;
  bool syncing_ = false;
};

}  // namespace loopmend
