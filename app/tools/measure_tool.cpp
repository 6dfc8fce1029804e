// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/measure_tool.h"

#include <QFontMetricsF>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>

#include <utility>

namespace loopmend {
namespace {

const QColor held(214, 104, 16), ink(24, 28, 34);

std::optional<QPointF> on_screen(const ViewSpace& space, const Vec3& point) {
  const Eigen::Vector3d at = space.to_screen(point);
  if (at.z() < 0) return std::nullopt;
  return QPointF(at.x(), at.y()) / space.ratio;
}

void paint_plate(QPainter& painter, const QPointF& middle, const QString& text) {
  QFont font = painter.font();
  font.setBold(true);
  painter.setFont(font);
  QRectF plate = QFontMetricsF(font).boundingRect(text);
  plate.adjust(-7, -4, 7, 4);
  plate.moveCenter(middle);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ink);
  painter.drawRoundedRect(plate, 4, 4);
  painter.setPen(Qt::white);
  painter.drawText(plate, Qt::AlignCenter, text);
}

}  // namespace

MeasureTool::MeasureTool(Snap snap, QObject* parent) : QObject(parent), snap_(std::move(snap)) {}

std::optional<Vec3> MeasureTool::way() const {
  if (ends_.size() < 2) return std::nullopt;
  return ends_[1] - ends_[0];
}

void MeasureTool::clear() {
  ends_.clear();
  Q_EMIT changed();
}

bool MeasureTool::mouse(Act act, const QMouseEvent& event, const ViewSpace& space) {
  at_ = event.localPos();
  if (act != Act::press) return act == Act::hover;
  if (event.button() != Qt::LeftButton || event.modifiers().testFlag(Qt::ShiftModifier)) return false;
  const std::optional<Vec3> surface = space.surface_at(at_);
  const std::optional<Vec3> vertex = surface ? snap_(*surface) : std::nullopt;
  if (!vertex) return false;  // beside the surface: the picture turns
  if (ends_.size() == 2) ends_.clear();
  ends_.push_back(*vertex);
  Q_EMIT changed();
  return true;
}

void MeasureTool::paint(QPainter& painter, const ViewSpace& space) {
  if (ends_.empty()) return;
  const std::optional<QPointF> from = on_screen(space, ends_.front());
  const std::optional<QPointF> to = ends_.size() == 2 ? on_screen(space, ends_.back()) : at_;
  if (!from || !to) return;
  painter.setPen(QPen(ink, 4));
  painter.drawLine(*from, *to);
  painter.setPen(QPen(held, 2, ends_.size() == 2 ? Qt::SolidLine : Qt::DashLine));
  painter.drawLine(*from, *to);
  painter.setPen(QPen(ink, 1.6));
  painter.setBrush(held);
  painter.drawEllipse(*from, 5, 5);
  if (ends_.size() < 2) return;
  painter.drawEllipse(*to, 5, 5);
  paint_plate(painter, (*from + *to) / 2, QLocale().toString(way()->norm(), 'g', 6));
}

}  // namespace loopmend
