// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a row of the holes table: a dot for the state, a soft band for the row under the mouse.
#pragma once

#include <QStyledItemDelegate>

namespace loopmend {

class Document;
class HoleSelection;

class HoleDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  HoleDelegate(const Document& document, const HoleSelection& selection, QObject* parent);
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  const Document& document_;
  const HoleSelection& selection_;
};

}  // namespace loopmend
