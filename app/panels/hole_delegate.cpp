// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/hole_delegate.h"

#include "document/document.h"
#include "document/hole_selection.h"
#include "document/hole_table.h"

#include <QPainter>
#include <QPainterPath>
#include <QSortFilterProxyModel>

namespace loopmend {
namespace {

constexpr int dot_column_px = 18;
constexpr double ground_px = 7.5;  ///< radius of what lies under the sign in a selected row

QPainterPath polyline(std::initializer_list<QPointF> points) {
  QPainterPath path(*points.begin());
  for (const QPointF& p : points) path.lineTo(p);
  return path;
}

}  // namespace

QColor sign_color(HoleState state) {
  switch (state) {
    case HoleState::open: return QColor(196, 0, 98);
    case HoleState::left_out: return QColor(150, 154, 160);
    case HoleState::filled: return QColor(120, 160, 200);
    case HoleState::running: return QColor(232, 170, 20);
    case HoleState::stepped: return QColor(70, 120, 190);
    case HoleState::converged:
    case HoleState::early_stop: return QColor(30, 140, 110);
    case HoleState::stalled: return QColor(200, 120, 20);
    case HoleState::cutting: return QColor(190, 50, 30);
    case HoleState::accepted: return QColor(30, 130, 70);
    case HoleState::failed: return QColor(190, 50, 30);
    case HoleState::faired: return QColor(30, 140, 110);
    case HoleState::look: return QColor(200, 120, 20);
    case HoleState::bad: return QColor(190, 50, 30);
  }
  return {};
}

void paint_sign(QPainter* painter, HoleState state, const QColor& color) {
  const QPen pen(color, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  painter->setPen(pen);
  painter->setBrush(Qt::NoBrush);
  const QRectF circle(-4, -4, 8, 8);
  switch (state) {
    case HoleState::open: painter->drawEllipse(circle); break;
    case HoleState::left_out: painter->drawLine(QPointF(-4, 0), QPointF(4, 0)); break;
    case HoleState::filled:
      painter->drawEllipse(circle);
      painter->setBrush(color);
      painter->drawPie(circle, 180 * 16, 180 * 16);
      break;
    case HoleState::running:
      painter->setBrush(color);
      painter->drawPath(polyline({{-2.5, -4}, {4, 0}, {-2.5, 4}, {-2.5, -4}}));
      break;
    case HoleState::stepped:
      painter->setBrush(color);
      painter->drawRect(QRectF(-3.5, -3.5, 2, 7));
      painter->drawRect(QRectF(1.5, -3.5, 2, 7));
      break;
    case HoleState::converged:
    case HoleState::early_stop:
      painter->setBrush(color);
      painter->drawEllipse(circle);
      break;
    case HoleState::stalled:
      painter->setBrush(color);
      painter->drawRect(QRectF(-3.2, -3.2, 6.4, 6.4));
      break;
    case HoleState::cutting:
      painter->drawPath(polyline({{0, -4}, {4.5, 3.8}, {-4.5, 3.8}, {0, -4}}));
      painter->drawLine(QPointF(0, -0.8), QPointF(0, 1.6));
      break;
    case HoleState::accepted: painter->drawPath(polyline({{-4, 0.4}, {-1.2, 3.4}, {4.2, -3.4}})); break;
    case HoleState::failed:
      painter->drawLine(QPointF(-3.4, -3.4), QPointF(3.4, 3.4));
      painter->drawLine(QPointF(-3.4, 3.4), QPointF(3.4, -3.4));
      break;
    case HoleState::faired:
      painter->drawEllipse(circle);
      painter->setBrush(color);
      painter->drawEllipse(QRectF(-1.6, -1.6, 3.2, 3.2));
      break;
    case HoleState::look: painter->drawPath(polyline({{0, -4}, {4.5, 3.8}, {-4.5, 3.8}, {0, -4}})); break;
    case HoleState::bad:
      painter->setBrush(color);
      painter->drawPath(polyline({{0, -4}, {4.5, 3.8}, {-4.5, 3.8}, {0, -4}}));
      break;
  }
}

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
  if (index.column() != HoleTable::state || loop >= document_.loop_count()) {
    QStyledItemDelegate::paint(painter, cell, index);
    return;
  }
  if (cell.state.testFlag(QStyle::State_Selected)) painter->fillRect(option.rect, option.palette.highlight());
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->translate(option.rect.left() + dot_column_px / 2.0 + 1, option.rect.center().y() + 0.5);
  const HoleState state = document_.state(loop);
  const bool selected = cell.state.testFlag(QStyle::State_Selected);
  if (selected) {  // its colour is that of the verdict, also there
    painter->setPen(Qt::NoPen);
    painter->setBrush(option.palette.color(QPalette::Base));
    painter->drawEllipse(QPointF(0, 0), ground_px, ground_px);
  }
  paint_sign(painter, state, sign_color(state));
  painter->restore();
  cell.rect.setLeft(option.rect.left() + dot_column_px);
  QStyledItemDelegate::paint(painter, cell, index);
}

}  // namespace loopmend
