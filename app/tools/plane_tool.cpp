// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/plane_tool.h"

#include <QMouseEvent>
#include <QPainter>

#include <cmath>

namespace loopmend {
namespace {

constexpr double grip_px = 9;
constexpr PlaneTool::Handle handles[] = {PlaneTool::Handle::move, PlaneTool::Handle::turn_first,
                                         PlaneTool::Handle::turn_second};

QPointF logical_pixels(const Eigen::Vector3d& point, const ViewSpace& space) {
  const Eigen::Vector3d at = space.to_screen(point);
  return at.z() < 0 ? QPointF(std::nan(""), std::nan("")) : QPointF(at.x(), at.y()) / space.ratio;
}

}  // namespace

PlaneTool::PlaneTool(const Document& document, PlaneGuide& guide, QObject* parent)
    : QObject(parent),
      document_(document),
      guide_(guide) {
  connect(&guide_, &PlaneGuide::changed, this, &PlaneTool::follow);
  for (auto signal : {&Document::opened, &Document::scans_changed})
    connect(&document_, signal, this, [this] {
      boxed_ = -1;
      follow();
    });
}

bool PlaneTool::has_plane() const { return guide_.plane() && document_.scan(guide_.scan()) && boxed_ == guide_.scan(); }

void PlaneTool::follow() {
  if (boxed_ != guide_.scan() && document_.scan(guide_.scan())) {
    boxed_ = guide_.scan();
    box_.setEmpty();
    for (const Vec3& p : document_.scan(boxed_)->model->soup.points) box_.extend(p - document_.origin());
  }
  Q_EMIT changed();
}

/// As large as the scan, its middle where the scan's middle falls on the plane.
PlaneTool::Frame PlaneTool::frame() const {
  const MirrorPlane& plane = *guide_.plane();
  const Eigen::Vector3d point = plane.point - document_.origin(), n = plane.normal;
  const double half = 0.4 * box_.diagonal().norm();
  Frame frame;
  frame.normal = n;
  frame.middle = box_.center() - n.dot(box_.center() - point) * n;
  frame.first = half * n.unitOrthogonal();
  frame.second = n.cross(frame.first);
  return frame;
}

QPointF PlaneTool::grip(Handle handle, const ViewSpace& space) const {
  const Frame f = frame();
  switch (handle) {
    case Handle::none: break;
    case Handle::move: return logical_pixels(f.middle, space);
    case Handle::turn_first: return logical_pixels(f.middle + f.first, space);
    case Handle::turn_second: return logical_pixels(f.middle + f.second, space);
  }
  return {-1, -1};
}

PlaneTool::Handle PlaneTool::handle_at(const QPointF& at, const ViewSpace& space) const {
  for (Handle handle : handles) {
    const QPointF off = grip(handle, space) - at;
    if (std::hypot(off.x(), off.y()) <= grip_px + 3) return handle;
  }
  return Handle::none;
}

bool PlaneTool::mouse(Act act, const QMouseEvent& event, const ViewSpace& space) {
  if (!has_plane()) return false;
  const QPointF at = event.localPos();
  switch (act) {
    case Act::hover: hovered_ = handle_at(at, space); return true;
    case Act::press:
      if (event.button() != Qt::LeftButton) return false;
      held_ = handle_at(at, space);
      pressed_ = at;
      before_ = frame();
      return held_ != Handle::none;
    case Act::move:
      if (held_ == Handle::none) return false;
      drag(at, space);
      return true;
    case Act::release:
      if (held_ == Handle::none) return false;
      held_ = Handle::none;
      guide_.let_go();
      return true;
  }
  return false;
}

/// A handle moves along the normal, by what the mouse has moved along the normal's picture.
void PlaneTool::drag(const QPointF& at, const ViewSpace& space) {
  const Eigen::Vector3d arm = held_ == Handle::turn_first    ? before_.first
                              : held_ == Handle::turn_second ? before_.second
                                                             : Eigen::Vector3d(0, 0, 0);
  const double size = before_.first.norm();
  const Eigen::Vector3d from = before_.middle + arm;
  const QPointF along = logical_pixels(from + size * before_.normal, space) - logical_pixels(from, space);
  const double length2 = QPointF::dotProduct(along, along);
  constexpr double least_px2 = 25;  // seen from along the normal
  if (!(length2 > least_px2)) return;
  const double moved = size * QPointF::dotProduct(at - pressed_, along) / length2;
  MirrorPlane plane = *guide_.plane();
  plane.misfit = 0;
  if (held_ == Handle::move) {
    plane.point = before_.middle + moved * before_.normal + document_.origin();
  } else {
    const Eigen::Vector3d turned = (arm + moved * before_.normal).normalized();
    plane.point = before_.middle + document_.origin();
    plane.normal = (before_.normal - before_.normal.dot(turned) * turned).normalized();
  }
  guide_.move_plane(plane);
}

/// To the side that goes.
void PlaneTool::paint_arrow(QPainter& painter, const ViewSpace& space) const {
  const Frame f = frame();
  const QPointF from = logical_pixels(f.middle, space);
  const QPointF tip = logical_pixels(f.middle + 0.5 * f.first.norm() * f.normal, space);
  const double length = std::hypot(tip.x() - from.x(), tip.y() - from.y());
  constexpr double head_px = 12;
  if (!(length > head_px)) return;  // seen from along the normal
  const QPointF along = (tip - from) / length, across(-along.y(), along.x());
  painter.setPen(QPen(QColor(214, 104, 16), 3));
  painter.setBrush(QColor(214, 104, 16));
  painter.drawLine(from, tip - along * head_px);
  QPolygonF head;
  head << tip << tip - along * head_px + across * head_px / 2 << tip - along * head_px - across * head_px / 2;
  painter.drawPolygon(head);
}

void PlaneTool::paint(QPainter& painter, const ViewSpace& space) {
  if (!has_plane()) return;
  const Frame f = frame();
  const QColor blue(20, 110, 190), ink(24, 28, 34);
  QPolygonF outline;
  for (const auto& corner :
       {Eigen::Vector3d(f.middle + f.first + f.second), Eigen::Vector3d(f.middle + f.first - f.second),
        Eigen::Vector3d(f.middle - f.first - f.second), Eigen::Vector3d(f.middle - f.first + f.second)}) {
    const QPointF at = logical_pixels(corner, space);
    if (!std::isfinite(at.x())) return;
    outline << at;
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(blue, 2));
  painter.setBrush(QColor(20, 110, 190, 40));
  painter.drawPolygon(outline);
  if (guide_.sides() == PlaneGuide::Sides::one_goes) paint_arrow(painter, space);
  for (Handle handle : handles) {
    const bool active = handle == held_ || (held_ == Handle::none && handle == hovered_);
    painter.setPen(QPen(ink, 1.6));
    painter.setBrush(active ? QColor(214, 104, 16) : handle == Handle::move ? blue : QColor(255, 255, 255));
    painter.drawEllipse(grip(handle, space), active ? grip_px : grip_px - 2, active ? grip_px : grip_px - 2);
  }
}

}  // namespace loopmend
