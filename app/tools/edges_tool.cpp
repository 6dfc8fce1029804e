// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/edges_tool.h"

#include <QMouseEvent>
#include <QPainter>

namespace loopmend {
namespace {

constexpr double reach = 8;  ///< logical pixels

/// Logical pixels; empty where a part of the line is behind the eye.
QPolygonF on_screen(const Points& line, const ViewSpace& space) {
  QPolygonF seen;
  for (const Vec3& p : line) {
    const Eigen::Vector3d at = space.to_screen(p);
    if (at.z() < 0) return {};
    seen << QPointF(at.x(), at.y()) / space.ratio;
  }
  return seen;
}

}  // namespace

EdgesTool::EdgesTool(const Document& document, const SceneVisibility& visibility, EdgeGuide& guide, QObject* parent)
    : QObject(parent),
      guide_(guide),
      ends_(document, visibility) {
  ends_.set_purpose(BridgeTool::Purpose::edge);
  connect(&ends_, &BridgeTool::changed, this, &EdgesTool::changed);
  connect(&ends_, &BridgeTool::edge_wanted, &guide_, &EdgeGuide::draw);
  connect(&guide_, &EdgeGuide::changed, this, [this] {
    hovered_ = -1;
    Q_EMIT changed();
  });
}

void EdgesTool::clear() { ends_.clear(); }

int EdgesTool::edge_at(const QPointF& at, const ViewSpace& space) const {
  int found = -1;
  double least = reach;
  for (std::size_t k = 0; k < guide_.edges().size(); ++k) {
    const QPolygonF line = on_screen(guide_.edges()[k].line, space);
    for (int i = 0; i + 1 < line.size(); ++i)
      if (const double d = distance_to_segment(at, line[i], line[i + 1]); d < least) {
        least = d;
        found = static_cast<int>(k);
      }
  }
  return found;
}

bool EdgesTool::mouse(Act act, const QMouseEvent& event, const ViewSpace& space) {
  if (ends_.mouse(act, event, space) && act == Act::press) return true;
  hovered_ = ends_.is_hovering() || ends_.is_begun() ? -1 : edge_at(event.localPos(), space);
  if (act != Act::press || hovered_ < 0 || event.button() != Qt::LeftButton) return act == Act::hover;
  const EdgeGuide::Edge edge = guide_.edges()[std::exchange(hovered_, -1)];
  guide_.remove(edge);
  return true;
}

void EdgesTool::paint(QPainter& painter, const ViewSpace& space) {
  const QColor by_itself(214, 104, 16), by_hand(20, 110, 190), ink(24, 28, 34);
  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t k = 0; k < guide_.edges().size(); ++k) {
    const EdgeGuide::Edge& edge = guide_.edges()[k];
    const QPolygonF line = on_screen(edge.line, space);
    const bool is_hovered = static_cast<int>(k) == hovered_;
    painter.setPen(QPen(ink, is_hovered ? 7 : 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    QPen pen(edge.kind == EdgeGuide::Edge::Kind::continued ? by_itself : by_hand, is_hovered ? 5 : 3, Qt::SolidLine,
             Qt::RoundCap, Qt::RoundJoin);
    if (edge.kind == EdgeGuide::Edge::Kind::not_fitting) {
      pen.setColor(QColor(255, 255, 255));
      pen.setStyle(Qt::DotLine);
    }
    painter.setPen(pen);
    painter.drawPolyline(line);
  }
  ends_.paint(painter, space);
}

QPointF EdgesTool::middle_of(std::size_t edge, const ViewSpace& space) const {
  const QPolygonF line = on_screen(guide_.edges()[edge].line, space);
  return line.isEmpty() ? QPointF(-1, -1) : 0.5 * (line[(line.size() - 1) / 2] + line[line.size() / 2]);
}

}  // namespace loopmend
