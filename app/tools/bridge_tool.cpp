// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/bridge_tool.h"

#include "core/error.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

constexpr double bridge_reach = 14;  ///< logical pixels
const QColor strip_color(214, 104, 16), strip_ink(24, 28, 34);

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
  hovered_ = begun_ = strip_to_ = -1;
  strip_.reset();
  maker_.reset();
  model_.reset();
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
  find_strip();
  if (act != Act::press) return act == Act::hover;
  if (event.button() != Qt::LeftButton || event.modifiers().testFlag(Qt::ShiftModifier)) return false;
  if (hovered_ < 0) return false;  // beside the boundaries: the picture turns
  const Seat second = seats_[hovered_];
  if (begun_ < 0 || seats_[begun_].scan != second.scan) {
    const int chosen = hovered_;
    clear();
    begun_ = hovered_ = chosen;
    if (purpose_ != Purpose::edge) {
      model_ = document_.scan(second.scan)->model;
      maker_ = std::make_unique<BridgeMaker>(*model_);
    }
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

void BridgeTool::find_strip() {
  const bool can_be = maker_ && hovered_ >= 0 && hovered_ != begun_ && seats_[hovered_].scan == seats_[begun_].scan;
  const int to = can_be ? hovered_ : -1;
  if (std::exchange(strip_to_, to) == to) return;
  strip_.reset();
  if (to < 0) return;
  try {
    strip_ = maker_->strip(seats_[begun_].soup_point, seats_[to].soup_point);
  } catch (const Error&) {
    // A click says why.
  }
}

std::vector<Vec3> BridgeTool::side_of_strip(Side side) const {
  const Points& own = model_->soup.points;
  std::vector<Vec3> line;
  for (const std::array<int, 3>& row : strip_->rows) {
    const auto at = static_cast<std::size_t>(side == Side::left ? row.front() : row.back());
    line.push_back(at < own.size() ? own[at] : strip_->points[at - own.size()]);
  }
  return line;
}

std::vector<Vec3> BridgeTool::new_edge() const {
  if (!strip_ || part().empty()) return {};
  return side_of_strip(is_forward() ? Side::left : Side::right);
}

bool BridgeTool::is_forward() const {
  const Seat& at = seats_[begun_];
  const int there = (hovered_ - begun_ + at.count) % at.count;
  return (length(begun_, there) <= length(hovered_, at.count - there)) != longer_;
}

/// The bridge takes the edges on both sides of both vertices: a part begins behind them.
std::vector<int> BridgeTool::part() const {
  if (purpose_ != Purpose::fill_part || begun_ < 0 || hovered_ < 0 || begun_ == hovered_) return {};
  const Seat& at = seats_[begun_];
  const int there = (hovered_ - begun_ + at.count) % at.count;
  const int from = is_forward() ? begun_ : hovered_, steps = is_forward() ? there : at.count - there;
  std::vector<int> seats;
  for (int k = 1; k < steps; ++k) seats.push_back(at.first + (from - at.first + k) % at.count);
  return seats;
}

std::vector<int> BridgeTool::lit_points() const {
  std::vector<int> points;
  for (int seat : part()) points.push_back(seats_[seat].soup_point);
  return points;
}

/// What a click would make: the strip, or the part with the edge that it would leave.
void BridgeTool::paint_strip(QPainter& painter, const ViewSpace& space) const {
  const Vec3& origin = document_.origin();
  const auto on_screen = [&](const std::vector<Vec3>& line) {
    QPolygonF shown;
    for (const Vec3& p : line)
      if (const Vec3 at = space.to_screen(p - origin); at.z() >= 0) shown << QPointF(at.x(), at.y()) / space.ratio;
    return shown;
  };
  const bool fills = purpose_ == Purpose::fill_part;
  std::vector<QPolygonF> edges{on_screen(fills ? new_edge() : side_of_strip(Side::left))};
  QPolygonF inside = edges.front();
  if (fills) {
    const Points& own = model_->soup.points;
    std::vector<Vec3> boundary;
    for (int seat : part()) boundary.push_back(own[static_cast<std::size_t>(seats_[seat].soup_point)]);
    const QPolygonF along = on_screen(boundary);
    // The part runs from the strip's first end on, or from its second.
    if (is_forward()) std::reverse(inside.begin(), inside.end());
    inside = along + inside;
    painter.setPen(QPen(strip_color, 3));
    painter.drawPolyline(along);
  } else {
    edges.push_back(on_screen(side_of_strip(Side::right)));
    inside += QPolygonF(QVector<QPointF>(edges.back().rbegin(), edges.back().rend()));
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(214, 104, 16, 60));
  painter.drawPolygon(inside);
  for (const QPolygonF& edge : edges) {
    painter.setPen(QPen(strip_ink, 4));
    painter.drawPolyline(edge);
    painter.setPen(QPen(strip_color, 2, Qt::DashLine));
    painter.drawPolyline(edge);
  }
}

void BridgeTool::paint(QPainter& painter, const ViewSpace& space) {
  take_loops();
  const QColor loose(255, 255, 255);
  const auto dot = [&](int seat, const QColor& color) {
    const QPointF at = points_.on_screen(space, seat);
    if (!std::isfinite(at.x())) return;
    painter.setPen(QPen(strip_ink, 1.6));
    painter.setBrush(color);
    painter.drawEllipse(at, 6, 6);
  };
  if (begun_ >= 0) {
    const QPointF from = points_.on_screen(space, begun_);
    const QPointF to = hovered_ >= 0 ? points_.on_screen(space, hovered_) : at_;
    if (strip_) {
      paint_strip(painter, space);
    } else if (std::isfinite(from.x()) && std::isfinite(to.x())) {
      painter.setPen(QPen(strip_ink, 4));
      painter.drawLine(from, to);
      painter.setPen(QPen(strip_color, 2, Qt::DashLine));
      painter.drawLine(from, to);
    }
    dot(begun_, strip_color);
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
