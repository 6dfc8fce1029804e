// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/bridge_tool.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

constexpr double bridge_reach = 14;  ///< logical pixels

}  // namespace

BridgeTool::BridgeTool(const Document& document, const SceneVisibility& visibility, QObject* parent)
    : QObject(parent),
      document_(document),
      visibility_(visibility) {
  connect(&visibility_, &SceneVisibility::changed, this, &BridgeTool::forget);
  for (auto signal : {&Document::opened, &Document::scans_changed, &Document::patches_changed})
    connect(&document_, signal, this, &BridgeTool::forget);
}

void BridgeTool::forget() {
  fresh_ = false;
  clear();
}

void BridgeTool::clear() {
  hovered_ = begun_ = -1;
  Q_EMIT changed();
}

void BridgeTool::set_purpose(Purpose purpose) {
  purpose_ = purpose;
  clear();
}

void BridgeTool::take_loops() {
  if (std::exchange(fresh_, true)) return;
  std::vector<float> xyz;
  seats_.clear();
  for (int loop = 0; loop < document_.loop_count(); ++loop) {
    if (!document_.present(loop) || document_.patch_of(loop) || visibility_.is_hidden_loop(loop)) continue;
    const int scan = document_.scan_of(loop);
    const auto opened = document_.scan(scan);
    const int first = static_cast<int>(seats_.size());
    for (int v : document_.loop(loop).vertices) {
      const auto begin = opened->shape->points.begin() + 3 * static_cast<std::ptrdiff_t>(v);
      xyz.insert(xyz.end(), begin, begin + 3);
      seats_.push_back({scan, opened->model->soup_vertex[v], loop, first, document_.loop(loop).edges()});
    }
  }
  points_.set_points(std::move(xyz));
}

bool BridgeTool::mouse(Act act, const QMouseEvent& event, const ViewSpace& space) {
  take_loops();
  at_ = event.localPos();
  hovered_ = points_.nearest(space, at_, bridge_reach);
  longer_ = event.modifiers().testFlag(Qt::ControlModifier);
  const auto seat = [this](int i) { return seats_[i]; };
  if (purpose_ != Purpose::bridge && begun_ >= 0 && hovered_ >= 0 && seat(begun_).loop != seat(hovered_).loop)
    hovered_ = -1;
  if (act != Act::press) return act == Act::hover;
  if (event.button() != Qt::LeftButton || event.modifiers().testFlag(Qt::ShiftModifier)) return false;
  if (hovered_ < 0) return false;  // beside the boundaries: the picture turns
  const Seat second = seats_[hovered_];
  if (begun_ < 0 || seats_[begun_].scan != second.scan) {
    begun_ = hovered_;
    Q_EMIT changed();
    return true;
  }
  const Seat first = seats_[begun_];
  const std::vector<int> chosen = part();
  const int beside = chosen.empty() ? -1 : seats_[chosen[chosen.size() / 2]].soup_point;
  clear();
  if (first == second) return true;
  switch (purpose_) {
    case Purpose::bridge: Q_EMIT bridge_wanted(first.scan, first.soup_point, second.soup_point); break;
    case Purpose::fill_part: Q_EMIT part_wanted(first.scan, first.soup_point, second.soup_point, beside); break;
    case Purpose::edge: Q_EMIT edge_wanted(first.scan, first.soup_point, second.soup_point); break;
  }
  return true;
}

double BridgeTool::length(int seat, int steps) const {
  const Seat& at = seats_[seat];
  double sum = 0;
  for (int k = 0; k < steps; ++k) {
    const int from = at.first + (seat - at.first + k) % at.count, to = at.first + (seat - at.first + k + 1) % at.count;
    sum += static_cast<double>((points_.point(to) - points_.point(from)).norm());
  }
  return sum;
}

/// The bridge takes the edges on both sides of both vertices: a part begins behind them.
std::vector<int> BridgeTool::part() const {
  if (purpose_ != Purpose::fill_part || begun_ < 0 || hovered_ < 0 || begun_ == hovered_) return {};
  const Seat& at = seats_[begun_];
  const int there = (hovered_ - begun_ + at.count) % at.count, back = at.count - there;
  const bool forth = (length(begun_, there) <= length(hovered_, back)) != longer_;
  const int from = forth ? begun_ : hovered_, steps = forth ? there : back;
  std::vector<int> seats;
  for (int k = 1; k < steps; ++k) seats.push_back(at.first + (from - at.first + k) % at.count);
  return seats;
}

std::vector<int> BridgeTool::lit_points() const {
  std::vector<int> points;
  for (int seat : part()) points.push_back(seats_[seat].soup_point);
  return points;
}

void BridgeTool::paint(QPainter& painter, const ViewSpace& space) {
  take_loops();
  const QColor held(214, 104, 16), loose(255, 255, 255), ink(24, 28, 34);
  const auto dot = [&](int seat, const QColor& color) {
    const QPointF at = points_.on_screen(space, seat);
    if (!std::isfinite(at.x())) return;
    painter.setPen(QPen(ink, 1.6));
    painter.setBrush(color);
    painter.drawEllipse(at, 6, 6);
  };
  if (begun_ >= 0) {
    const QPointF from = points_.on_screen(space, begun_);
    const QPointF to = hovered_ >= 0 ? points_.on_screen(space, hovered_) : at_;
    QPolygonF along;
    for (int seat : part())
      if (const QPointF at = points_.on_screen(space, seat); std::isfinite(at.x())) along << at;
    if (along.size() > 1) {
      painter.setBrush(QColor(214, 104, 16, 60));
      painter.setPen(QPen(held, 3));
      painter.drawPolygon(along);
    }
    if (std::isfinite(from.x()) && std::isfinite(to.x())) {
      painter.setPen(QPen(ink, 4));
      painter.drawLine(from, to);
      painter.setPen(QPen(held, 2, Qt::DashLine));
      painter.drawLine(from, to);
    }
    dot(begun_, held);
  }
  if (hovered_ >= 0 && hovered_ != begun_) dot(hovered_, loose);
}

QPointF BridgeTool::position_of(int scan, int soup_point, const ViewSpace& space) {
  take_loops();
  const auto found = std::find_if(seats_.begin(), seats_.end(),
                                  [&](const Seat& seat) { return seat.scan == scan && seat.soup_point == soup_point; });
  return found == seats_.end() ? QPointF(-1, -1) : points_.on_screen(space, static_cast<int>(found - seats_.begin()));
}

}  // namespace loopmend
