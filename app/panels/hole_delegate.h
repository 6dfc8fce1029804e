// SPDX-License-Identifier: GPL-3.0-or-later
// Draws a row of the holes table: a dot for the state, a soft band for the row under the mouse.
#pragma once

#include <QStyledItemDelegate>

namespace loopmend {

class Document;
class HoleSelection;
enum class HoleState;

QColor sign_color(HoleState state);
/// A sign of its own for each state, so that colour is not needed to tell them apart; within ±4.
void paint_sign(QPainter* painter, HoleState state, const QColor& color);

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
