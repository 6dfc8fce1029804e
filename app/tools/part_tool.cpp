// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/part_tool.h"

#include "tools/screen_points.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace loopmend {
namespace {

constexpr double arrow_px = 92, ring_px = 70, pick_px = 8, slide_px = 11, scale_px = 9;
constexpr int ring_points = 72;
constexpr double pi = 3.14159265358979323846;
const std::array<QColor, 3> axis_inks{QColor(200, 60, 50), QColor(60, 140, 50), QColor(50, 95, 200)};

int axis_of(PartTool::Handle handle) {
  using H = PartTool::Handle;
  switch (handle) {
    case H::move_x:
    case H::turn_x: return 0;
    case H::move_y:
    case H::turn_y: return 1;
    case H::move_z:
    case H::turn_z: return 2;
    default: return -1;
  }
}

QPointF logical(const Eigen::Vector3d& pixel, const ViewSpace& space) {
  return {pixel.x() / space.ratio, pixel.y() / space.ratio};
}

double distance(const QPointF& a, const QPointF& b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

/// What lies under a place of the screen, as deep as `like`.
Eigen::Vector3d lifted(const QPointF& at, const Eigen::Vector3d& like, const ViewSpace& space) {
  const double depth = space.to_screen(like).z();
  const Eigen::Vector4d clip(2 * at.x() * space.ratio / space.width - 1, 1 - 2 * at.y() * space.ratio / space.height,
                             2 * depth - 1, 1);
  const Eigen::Vector4d world = space.to_clip.inverse() * clip;
  return world.head<3>() / world.w();
}

}  // namespace

PartTool::PartTool(const Document& document, QObject* parent) : QObject(parent), document_(document) {}

void PartTool::set_scan(int scan) {
  scan_ = scan;
  placement_.setIdentity();
  held_ = hovered_ = Handle::none;
  if (scan < 0 || !document_.scan(scan)) {
    scan_ = -1;
    return;
  }
  Eigen::AlignedBox3d box;
  const std::vector<float>& points = document_.scan(scan)->shape->points;
  for (std::size_t i = 0; i + 2 < points.size(); i += 3)
    box.extend(Eigen::Vector3d(points[i], points[i + 1], points[i + 2]));
  middle_ = box.center();
}

void PartTool::set_placement(const Eigen::Affine3d& placement) {
  placement_ = placement;
  Q_EMIT placed();
}

/// How long 1 logical pixel is at the handle.
double PartTool::reach(const ViewSpace& space) const {
  const Eigen::Vector3d m = middle();
  const QPointF at = logical(space.to_screen(m), space);
  return (lifted(at + QPointF(1, 0), m, space) - m).norm();
}

std::vector<QPointF> PartTool::ring(int axis, const ViewSpace& space) const {
  const double radius = ring_px * reach(space);
  const Eigen::Vector3d u = Eigen::Vector3d::Unit((axis + 1) % 3), v = Eigen::Vector3d::Unit((axis + 2) % 3);
  std::vector<QPointF> line;
  for (int i = 0; i <= ring_points; ++i) {
    const double angle = 2 * pi * i / ring_points;
    line.push_back(logical(space.to_screen(middle() + radius * (std::cos(angle) * u + std::sin(angle) * v)), space));
  }
  return line;
}

QPointF PartTool::grip(Handle handle, const ViewSpace& space) const {
  const QPointF at = logical(space.to_screen(middle()), space);
  const int axis = axis_of(handle);
  if (handle == Handle::slide) return at;
  if (handle == Handle::scale) return at + QPointF(0.75 * arrow_px, -0.75 * arrow_px);
  if (handle == Handle::turn_x || handle == Handle::turn_y || handle == Handle::turn_z) {
    // Where the ring is farthest from the other handles.
    const std::vector<QPointF> line = ring(axis, space);
    QPointF best = line.front();
    double room = -1;
    for (const QPointF& p : line) {
      double nearest = 1e9;
      for (Handle other : {Handle::move_x, Handle::move_y, Handle::move_z})
        nearest = std::min(nearest, distance_to_segment(p, at, grip(other, space)));
      for (int k = 0; k < 3; ++k)
        if (k != axis)
          for (const QPointF& q : ring(k, space)) nearest = std::min(nearest, distance(p, q));
      if (nearest > room) {
        room = nearest;
        best = p;
      }
    }
    return best;
  }
  return logical(space.to_screen(middle() + arrow_px * reach(space) * Eigen::Vector3d::Unit(axis)), space);
}

PartTool::Handle PartTool::handle_at(const QPointF& at, const ViewSpace& space) const {
  const QPointF m = logical(space.to_screen(middle()), space);
  if (distance(at, m) <= slide_px) return Handle::slide;
  if (distance(at, grip(Handle::scale, space)) <= scale_px + 3) return Handle::scale;
  Handle best = Handle::none;
  double best_distance = pick_px;
  const std::array<Handle, 3> moves{Handle::move_x, Handle::move_y, Handle::move_z},
      turns{Handle::turn_x, Handle::turn_y, Handle::turn_z};
  for (int axis = 0; axis < 3; ++axis) {
    const double d = distance_to_segment(at, m, grip(moves[axis], space));
    if (d < best_distance) {
      best_distance = d;
      best = moves[axis];
    }
    const std::vector<QPointF> line = ring(axis, space);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const double r = distance_to_segment(at, line[i], line[i + 1]);
      if (r >= best_distance) continue;
      best_distance = r;
      best = turns[axis];
    }
  }
  return best;
}

void PartTool::drag(const QPointF& at, const ViewSpace& space) {
  const Eigen::Vector3d m = placement_before_ * middle_;
  const QPointF m2 = logical(space.to_screen(m), space);
  const int axis = axis_of(held_);
  Eigen::Affine3d change = Eigen::Affine3d::Identity();
  if (held_ == Handle::slide) {
    change.pretranslate(lifted(at, m, space) - lifted(pressed_, m, space));
  } else if (held_ == Handle::scale) {
    const double factor = std::clamp(distance(at, m2) / std::max(1.0, distance(pressed_, m2)), 0.02, 50.0);
    change = Eigen::Translation3d(m) * Eigen::Scaling(factor) * Eigen::Translation3d(-m);
  } else if (held_ == Handle::move_x || held_ == Handle::move_y || held_ == Handle::move_z) {
    const double unit = 20 * (lifted(m2 + QPointF(1, 0), m, space) - m).norm();
    const QPointF way = logical(space.to_screen(m + unit * Eigen::Vector3d::Unit(axis)), space) - m2;
    const double length2 = QPointF::dotProduct(way, way);
    if (length2 < 1) return;  // the axis points into the eye: no movement of the mouse means anything
    change.pretranslate(unit * QPointF::dotProduct(at - pressed_, way) / length2 * Eigen::Vector3d::Unit(axis));
  } else {
    const auto angle = [&](const QPointF& p) { return std::atan2(-(p.y() - m2.y()), p.x() - m2.x()); };
    // Turning with the mouse, as seen: against the axis where that looks away.
    const double depth_step = reach(space);
    const bool towards_eye = space.to_screen(m + depth_step * Eigen::Vector3d::Unit(axis)).z() < space.to_screen(m).z();
    const double turn = (towards_eye ? 1 : -1) * (angle(at) - angle(pressed_));
    change = Eigen::Translation3d(m) * Eigen::AngleAxisd(turn, Eigen::Vector3d::Unit(axis)) * Eigen::Translation3d(-m);
  }
  set_placement(change * placement_before_);
}

bool PartTool::mouse(Act act, const QMouseEvent& event, const ViewSpace& space) {
  if (scan_ < 0) return false;
  const QPointF at = event.localPos();
  if (act == Act::hover) {
    hovered_ = handle_at(at, space);
    return hovered_ != Handle::none;
  }
  if (act == Act::press) {
    if (event.button() != Qt::LeftButton) return false;
    held_ = handle_at(at, space);
    pressed_ = at;
    placement_before_ = placement_;
    return held_ != Handle::none;
  }
  drag(at, space);
  if (act != Act::release) return true;
  held_ = Handle::none;
  Q_EMIT released();
  return true;
}

void PartTool::paint(QPainter& painter, const ViewSpace& space) {
  if (scan_ < 0) return;
  const Handle lit = held_ != Handle::none ? held_ : hovered_;
  const QPointF m = logical(space.to_screen(middle()), space);
  const auto stroke = [&](const QPolygonF& line, const QColor& ink, bool strong) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(255, 255, 255, 200), strong ? 6 : 4, Qt::SolidLine, Qt::RoundCap));
    painter.drawPolyline(line);
    painter.setPen(QPen(ink, strong ? 3.5 : 2, Qt::SolidLine, Qt::RoundCap));
    painter.drawPolyline(line);
  };
  const std::array<Handle, 3> moves{Handle::move_x, Handle::move_y, Handle::move_z},
      turns{Handle::turn_x, Handle::turn_y, Handle::turn_z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::vector<QPointF> line = ring(static_cast<int>(axis), space);
    stroke(QPolygonF(QVector<QPointF>(line.begin(), line.end())), axis_inks[axis], lit == turns[axis]);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const QPointF end = grip(moves[axis], space), way = end - m;
    stroke(QPolygonF(QVector<QPointF>{m, end}), axis_inks[axis], lit == moves[axis]);
    const double length = std::hypot(way.x(), way.y());
    if (length < 8) continue;
    const QPointF along = way / length, across(-along.y(), along.x());
    painter.setPen(QPen(QColor(255, 255, 255, 220), 1));
    painter.setBrush(axis_inks[axis]);
    painter.drawPolygon(QPolygonF(QVector<QPointF>{end + 9 * along, end + 6 * across, end - 6 * across}));
  }
  painter.setPen(QPen(QColor(24, 28, 34), lit == Handle::slide ? 2.4 : 1.2));
  painter.setBrush(QColor(255, 255, 255, 235));
  painter.drawEllipse(m, slide_px - 2, slide_px - 2);
  const QPointF corner = grip(Handle::scale, space);
  painter.setPen(QPen(QColor(24, 28, 34, 160), 1, Qt::DotLine));
  painter.drawLine(m, corner);
  painter.setPen(QPen(QColor(24, 28, 34), lit == Handle::scale ? 2.4 : 1.2));
  painter.drawRect(QRectF(corner - QPointF(scale_px, scale_px) * 0.75, QSizeF(1.5 * scale_px, 1.5 * scale_px)));
}

}  // namespace loopmend
