// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/view_overlay.h"

#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace loopmend {
namespace {

const std::array<QColor, 3> axis_colors{QColor(205, 62, 58), QColor(70, 150, 60), QColor(52, 104, 200)};
constexpr int axis_margin = 46;
constexpr double axis_length = 28;
constexpr double longest_scale_bar = 150;
constexpr double mark_distance = 12;  ///< between a seam and the corners around it
const QColor mark_shadow(20, 24, 30, 110), mark_color(255, 214, 40);

/// The largest of 1, 2, 5 times a power of ten that is not above the length.
double round_length(double length) {
  const double decade = std::pow(10.0, std::floor(std::log10(length)));
  for (double step : {5.0, 2.0})
    if (step * decade <= length) return step * decade;
  return decade;
}

/// Without points that lie two pixels or less from the last one: wide pens take their time at every corner.
QPolygonF thinned(const QPolygonF& line) {
  constexpr double pixel = 2;
  QPolygonF thin;
  for (const QPointF& point : line)
    if (thin.isEmpty() || (point - thin.last()).manhattanLength() >= pixel) thin << point;
  return thin.size() < 3 ? line : thin;
}

QRectF caption_box(const QFontMetricsF& metrics, const QPolygonF& loop, const QString& text, const QSize& inside) {
  QRectF box(0, 0, metrics.horizontalAdvance(text) + 16, metrics.height() + 8);
  const QRectF bounds = loop.boundingRect();
  box.moveCenter(QPointF(bounds.center().x(), bounds.top() - box.height() / 2 - 8));
  if (box.top() < 8) box.moveTop(std::min(bounds.bottom() + 8, inside.height() - box.height() - 8));
  box.moveLeft(std::clamp(box.left(), 8.0, std::max(8.0, inside.width() - box.width() - 8)));
  return box;
}

}  // namespace

ViewOverlay::ViewOverlay(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setObjectName(QStringLiteral("viewOverlay"));
}

void ViewOverlay::set_highlight(const QPolygonF& loop, const QString& caption) {
  clear_highlight();
  loop_ = thinned(loop);
  caption_ = caption;
  update(around_highlight());
}

void ViewOverlay::clear_highlight() {
  if (loop_.isEmpty()) return;
  update(around_highlight());
  loop_.clear();
}

/// Outline and caption: to paint all of a large window takes longer.
QRegion ViewOverlay::around_highlight() const {
  constexpr int outline = 6, smooth = 2;
  const QRect loop = loop_.boundingRect().toAlignedRect().adjusted(-outline, -outline, outline, outline);
  const QRect caption = caption_box(QFontMetricsF(font()), loop_, caption_, size()).toAlignedRect();
  return QRegion(loop).united(caption.adjusted(-smooth, -smooth, smooth, smooth));
}

void ViewOverlay::set_marks(const std::vector<Mark>& marks) {
  if (marks == marks_) return;
  const QRegion before = around_marks();
  marks_ = marks;
  update(before.united(around_marks()));
}

QRegion ViewOverlay::around_marks() const {
  constexpr double pen = 4;
  constexpr double out = mark_distance + pen;
  QRegion around;
  for (const Mark& mark : marks_) around += mark.box.adjusted(-out, -out, out, out).toAlignedRect();
  return around;
}

void ViewOverlay::set_probe(const QPointF& at, const QStringList& lines) {
  probe_ = at;
  probe_lines_ = lines;
  update();
}

void ViewOverlay::clear_probe() {
  if (probe_lines_.isEmpty()) return;
  probe_lines_.clear();
  update();
}

void ViewOverlay::set_scale(double length_per_pixel) {
  length_per_pixel_ = length_per_pixel;
  update();
}

void ViewOverlay::set_unit(const QString& symbol) {
  unit_ = symbol;
  update();
}

void ViewOverlay::set_axes(const Eigen::Matrix3d& axes) {
  axes_ = axes;
  with_axes_ = true;
  update();
}

void ViewOverlay::hide_axes() {
  with_axes_ = false;
  update();
}

void ViewOverlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paint_frame(painter);
  paint_marks(painter);
  if (!loop_.isEmpty()) paint_highlight(painter);
  if (!probe_lines_.isEmpty()) paint_probe(painter);
}

void ViewOverlay::paint_frame(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  if (!with_axes_) return;
  paint_axes(painter);
  if (length_per_pixel_ > 0) paint_scale(painter);
}

void ViewOverlay::paint_scale(QPainter& painter) const {
  const double length = round_length(longest_scale_bar * length_per_pixel_);
  const double width = length / length_per_pixel_;
  const double left = 2 * axis_margin + 8, y = height() - 22;
  const QColor ink = palette().color(QPalette::WindowText);
  const auto bar = [&](const QColor& color, double pen) {
    painter.setPen(QPen(color, pen, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(left, y), QPointF(left + width, y));
    for (double x : {left, left + width}) painter.drawLine(QPointF(x, y - 4), QPointF(x, y + 4));
  };
  QColor halo = palette().color(QPalette::Window);
  halo.setAlpha(140);
  bar(halo, 4.5);
  bar(ink, 1.6);
  painter.setPen(ink);
  painter.drawText(QRectF(left - 40, y - 26, width + 80, 20), Qt::AlignHCenter | Qt::AlignBottom,
                   (QLocale().toString(length, 'g', 3) + QLatin1Char(' ') + unit_).trimmed());
}

void ViewOverlay::paint_probe(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(QColor(255, 255, 255), 4));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(probe_, 5, 5);
  painter.setPen(QPen(QColor(20, 24, 30), 2));
  painter.drawEllipse(probe_, 5, 5);
  const QFontMetricsF metrics(painter.font());
  double width = 0;
  for (const QString& line : probe_lines_) width = std::max(width, metrics.horizontalAdvance(line));
  QRectF box(0, 0, width + 18, metrics.height() * probe_lines_.size() + 12);
  box.moveTopLeft(probe_ + QPointF(14, -box.height() - 8));
  if (box.right() > this->width() - 8) box.moveRight(probe_.x() - 14);
  if (box.top() < 8) box.moveTop(probe_.y() + 14);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(24, 28, 34, 225));
  painter.drawRoundedRect(box, 5, 5);
  painter.setPen(QColor(245, 245, 242));
  painter.drawText(box.adjusted(9, 6, -9, -6), Qt::AlignLeft | Qt::AlignVCenter, probe_lines_.join(QLatin1Char('\n')));
}

void ViewOverlay::paint_highlight(QPainter& painter) const {
  // Round joins take half of the time of a long loop, whose corners are invisible.
  constexpr int few_corners = 60;
  const Qt::PenJoinStyle join = loop_.size() > few_corners ? Qt::BevelJoin : Qt::RoundJoin;
  const auto stroke = [&](const QColor& color, double width) {
    painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap, join));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(loop_);
  };
  stroke(mark_shadow, 9);
  stroke(mark_color, 6);
  stroke(QColor(255, 250, 220), 2);
  if (caption_.isEmpty()) return;
  const QRectF box = caption_box(QFontMetricsF(font()), loop_, caption_, size());
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(24, 28, 34, 225));
  painter.drawRoundedRect(box, 5, 5);
  painter.setPen(QColor(245, 245, 242));
  painter.drawText(box, Qt::AlignCenter, caption_);
}

void ViewOverlay::paint_marks(QPainter& painter) const {
  constexpr double share = 0.2, shortest = 6, longest = 24, faint = 0.45;
  for (const Mark& mark : marks_) {
    const QRectF box = mark.box.adjusted(-mark_distance, -mark_distance, mark_distance, mark_distance);
    const double arm = std::clamp(share * std::min(box.width(), box.height()), shortest, longest);
    painter.setOpacity(mark.side == Mark::Side::seen ? 1 : faint);
    for (const auto& [color, width] : {std::pair{mark_shadow, 6.0}, std::pair{mark_color, 3.0}}) {
      painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      for (const QPointF& corner : {box.topLeft(), box.topRight(), box.bottomRight(), box.bottomLeft()}) {
        const QPointF inward(corner.x() < box.center().x() ? arm : -arm, corner.y() < box.center().y() ? arm : -arm);
        painter.drawPolyline(
            QPolygonF(QVector<QPointF>{corner + QPointF(inward.x(), 0), corner, corner + QPointF(0, inward.y())}));
      }
    }
  }
  painter.setOpacity(1);
}

void ViewOverlay::paint_axes(QPainter& painter) const {
  const QPointF middle(axis_margin, height() - axis_margin);
  std::array<int, 3> far_first{0, 1, 2};
  std::sort(far_first.begin(), far_first.end(), [this](int a, int b) { return axes_(2, a) < axes_(2, b); });
  const char* const names[] = {"x", "y", "z"};
  for (int axis : far_first) {
    const QPointF way(axes_(0, axis), -axes_(1, axis));
    QColor color = axis_colors[axis];
    if (axes_(2, axis) < -0.2) color.setAlpha(140);
    painter.setPen(QPen(QColor(255, 255, 255, 110), 4.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(middle, middle + axis_length * way);
    painter.setPen(QPen(color, 2.2, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(middle, middle + axis_length * way);
    painter.setPen(palette().color(QPalette::WindowText));
    const QPointF label = middle + (axis_length + 9) * way;
    painter.drawText(QRectF(label - QPointF(8, 8), QSizeF(16, 16)), Qt::AlignCenter, QLatin1String(names[axis]));
  }
}

}  // namespace loopmend
