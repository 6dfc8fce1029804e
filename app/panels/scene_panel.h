// SPDX-License-Identifier: GPL-3.0-or-later
// The dock that lists what is in the scene: scans, their pieces by size, their patches. A check box hides and shows each.
#pragma once

#include "document/scene_visibility.h"

#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace loopmend {

class ScenePanel : public QWidget {
  Q_OBJECT

 public:
  ScenePanel(const Document& document, SceneVisibility& visibility, QWidget* parent = nullptr);

  /// More pieces or patches than this have one row together.
  static constexpr int most_rows = 200;

 Q_SIGNALS:
  /// A right click on a row. @param at  of the screen
  /// By length_unit.h; empty: not known.
  void unit_chosen(const std::string& unit);
  void menu_wanted(const std::set<PieceId>& pieces, const QPoint& at);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  enum class Row { scan, piece, small_pieces, patches, patch };
  void rebuild();
  void add_scan(int scan);
  void add_patches(QTreeWidgetItem* scan_row, int scan);
  QTreeWidgetItem* add_row(QTreeWidgetItem* parent, Row kind, int scan, int number, const QString& name,
                           const QString& size);
  void show_checks();
  void on_checked(QTreeWidgetItem* row);
  /// What a row stands for.
  std::set<PieceId> pieces_of(const QTreeWidgetItem* row) const;
  std::set<int> patches_of(const QTreeWidgetItem* row) const;
  Qt::CheckState check_of(const QTreeWidgetItem* row) const;
  void isolate_current();
  void show_unit();

  const Document& document_;
  SceneVisibility& visibility_;
  QTreeWidget* tree_;
  QPushButton *isolate_, *show_all_;
  QLabel* note_;
  QComboBox* unit_;
  QTimer later_{this};  ///< patches come one by one, in hundreds
  bool syncing_ = false;
};

}  // namespace loopmend
