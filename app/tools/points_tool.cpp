// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/points_tool.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

constexpr double pick_reach = 12, box_slack = 5;  ///< logical pixels
constexpr int most_dots = 6000;                   ///< beyond these the dots hide the surface

}  // namespace

PointsTool::PointsTool(const Document& document, const SceneVisibility& visibility, QObject* parent)
    : QObject(parent),
      document_(document),
      visibility_(visibility) {
  connect(&visibility_, &SceneVisibility::changed, this, &PointsTool::forget);
  connect(&document_, &Document::opened, this, &PointsTool::forget);
  connect(&document_, &Document::scans_changed, this, &PointsTool::forget);
}

void PointsTool::forget() {
  fresh_ = false;
  fixed_.clear();
  hovered_ = -1;
  if (scan_ >= 0 && !document_.scan(scan_)) scan_ = -1;
  Q_EMIT changed();
}

int PointsTool::scan() const {
  if (scan_ >= 0 && document_.scan(scan_)) return scan_;
  const std::vector<int> all = document_.scans();
  return all.empty() ? -1 : all.front();
}

void PointsTool::set_scan(int scan) {
  scan_ = scan;
  forget();
}

void PointsTool::set_choice(Choice choice) {
  choice_ = choice;
  Q_EMIT changed();
}

void PointsTool::clear() {
  std::fill(fixed_.begin(), fixed_.end(), 0);
  Q_EMIT changed();
}

void PointsTool::take_surface() {
  if (fresh_ || scan() < 0) return;
  fresh_ = true;
  const auto opened = document_.scan(scan());
  soup_ = opened->model->soup_vertex;
  std::vector<char> unseen;
  for (int v = 0; v < static_cast<int>(soup_.size()); ++v) unseen.push_back(visibility_.is_hidden_vertex(scan(), v));
  points_.set_points(opened->shape->points, std::move(unseen));
  fixed_.assign(soup_.size(), 0);
}

std::vector<int> PointsTool::fixed() const {
  std::vector<int> points;
  if (choice_ == Choice::all) return points;
  for (std::size_t i = 0; i < fixed_.size(); ++i)
    if (fixed_[i]) points.push_back(soup_[i]);
  std::sort(points.begin(), points.end());
  return points;
}

int PointsTool::count() const {
  if (scan() < 0) return 0;
  if (choice_ == Choice::all) return static_cast<int>(document_.scan(scan())->model->soup_vertex.size());
  return static_cast<int>(std::count(fixed_.begin(), fixed_.end(), 1));
}

bool PointsTool::mouse(Act act, const QMouseEvent& event, const ViewSpace& space) {
  if (choice_ == Choice::all) return false;
  take_surface();
  at_ = event.localPos();
  if (act == Act::hover) {
    hovered_ = points_.nearest(space, at_, pick_reach);
    return true;
  }
  if (act == Act::press) {
    if (event.button() != Qt::LeftButton || event.modifiers().testFlag(Qt::ShiftModifier)) return false;
    pressed_ = at_;
    boxing_ = false;
    return true;
  }
  if ((at_ - pressed_).manhattanLength() > box_slack) boxing_ = true;
  if (act != Act::release) return true;
  const char wanted = !event.modifiers().testFlag(Qt::ControlModifier);
  if (std::exchange(boxing_, false)) {
    const QRectF box = QRectF(pressed_, at_).normalized();
    for (int v : points_.within(space, QPolygonF(box), ScreenPoints::Hidden::taken)) fixed_[v] = wanted;
  } else if (const int v = points_.nearest(space, at_, pick_reach); v >= 0) {
    char& one = fixed_[v];
    one = !one;
  }
  Q_EMIT changed();
  return true;
}

void PointsTool::paint(QPainter& painter, const ViewSpace& space) {
  take_surface();
  if (scan() < 0 || points_.count() > most_dots) return;
  const QColor held(214, 104, 16), loose(255, 255, 255), ink(24, 28, 34);
  for (int i = 0; i < points_.count(); ++i) {
    const QPointF at = points_.on_screen(space, i);
    if (!std::isfinite(at.x()) || !points_.is_seen(space, i)) continue;
    const bool fixed = choice_ == Choice::all || fixed_[i];
    painter.setPen(QPen(ink, i == hovered_ ? 2.2 : 1.1));
    painter.setBrush(fixed ? held : loose);
    const double radius = i == hovered_ ? 6.5 : fixed ? 4.5 : 3.5;
    painter.drawEllipse(at, radius, radius);
  }
  if (!boxing_) return;
  painter.setPen(QPen(ink, 1.2, Qt::DashLine));
  painter.setBrush(QColor(214, 104, 16, 36));
  painter.drawRect(QRectF(pressed_, at_).normalized());
}

QPointF PointsTool::position_of(int soup_point, const ViewSpace& space) {
  take_surface();
  const auto found = std::find(soup_.begin(), soup_.end(), soup_point);
  return found == soup_.end() ? QPointF(-1, -1) : points_.on_screen(space, static_cast<int>(found - soup_.begin()));
}

}  // namespace loopmend
