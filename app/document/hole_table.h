// SPDX-License-Identifier: GPL-3.0-or-later
// The holes as a table: one row per boundary loop of the document; row and loop index are the same.
#pragma once

#include <QAbstractTableModel>

namespace loopmend {

class Document;
struct BoundarySummary;

class HoleTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column {
    number,
    edges,
    diameter,
    perimeter,
    area,
    planarity,
    kind,
    scan,
    boundary,
    crease,
    deviation,
    state,
    column_count
  };
  /// For sorting: the bare number behind a cell.
  static constexpr int sort_role = Qt::UserRole + 1;

  explicit HoleTable(const Document& document, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  /// "Diameter, mm"
  QString with_unit(const QString& title) const;
  void follow_unit();
  void follow_rows();
  QVariant text(int loop, int column) const;
  QVariant sort_key(int loop, int column) const;
  QVariant tool_tip(int loop, int column) const;
  const BoundarySummary* boundary_of(int loop) const;

  const Document& document_;
  QString unit_;  ///< kept here: a table asks for its headers while the window goes, when the document has gone
  int rows_ = 0;
};

}  // namespace loopmend
