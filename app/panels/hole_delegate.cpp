#include "panels/hole_delegate.h"

#include "document/document.h"
#include "document/hole_selection.h"
#include "document/hole_table.h"

#include <QPainter>
#include <QSortFilterProxyModel>

namespace loopmend {
namespace {

constexpr int dot_column_px = 18;
constexpr double dot_px = 8;

QColor dot_color(HoleState state) {
  switch (state) {
    case HoleState::open: return QColor(196, 0, 98);
    case HoleState::left_out: return QColor(150, 154, 160);
    case HoleState::filled: return QColor(120, 160, 200);
    case HoleState::running: return QColor(232, 170, 20);
    case HoleState::stepped: return QColor(70, 120, 190);
    case HoleState::converged: return QColor(30, 140, 110);
    case HoleState::failed: return QColor(190, 50, 30);
  }
  return {};
}

}  // namespace

HoleDelegate::HoleDelegate(const Document& document, const HoleSelection& selection, QObject* parent)
    : QStyledItemDelegate(parent),
      document_(document),
      selection_(selection) {}

void HoleDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const auto* proxy = static_cast<const QSortFilterProxyModel*>(index.model());
  const int loop = proxy->mapToSource(index).row();
  QStyleOptionViewItem cell = option;
  cell.state &= ~(QStyle::State_HasFocus | QStyle::State_MouseOver);
  if (loop == selection_.hovered() && !cell.state.testFlag(QStyle::State_Selected)) {
    QColor band = option.palette.color(QPalette::Highlight);
    band.setAlphaF(0.16);
    painter->fillRect(option.rect, band);
  }
  if (index.column() != HoleTable::state || loop >= static_cast<int>(document_.loops().size())) {
    QStyledItemDelegate::paint(painter, cell, index);
    return;
  }
  if (cell.state.testFlag(QStyle::State_Selected)) painter->fillRect(option.rect, option.palette.highlight());
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  const QPointF middle(option.rect.left() + dot_column_px / 2.0 + 1, option.rect.center().y() + 0.5);
  const HoleState state = document_.state(loop);
  const bool hollow = state == HoleState::open || state == HoleState::left_out;
  const QColor color = dot_color(state);
  painter->setPen(
      QPen(cell.state.testFlag(QStyle::State_Selected) ? option.palette.color(QPalette::Base) : color, 1.6));
  painter->setBrush(hollow ? QBrush(Qt::NoBrush) : QBrush(color));
  painter->drawEllipse(middle, dot_px / 2, dot_px / 2);
  painter->restore();
  cell.rect.setLeft(option.rect.left() + dot_column_px);
  QStyledItemDelegate::paint(painter, cell, index);
}

}  // namespace loopmend
