// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/view_cube.h"

#include <QPainter>
#include <QTransform>

#include <algorithm>
#include <array>

namespace loopmend {
namespace {

constexpr std::array cube_sides{NamedView::front, NamedView::back, NamedView::left,
                                NamedView::right, NamedView::top,  NamedView::bottom};
constexpr double half_edge = 27;     // logical pixels: the cube fits into the widget however it is turned
constexpr double least_depth = 0.1;  // of a face that can be read

QString word_on(NamedView side) {
  switch (side) {
    case NamedView::front: return ViewCube::tr("Front");
    case NamedView::back: return ViewCube::tr("Back");
    case NamedView::left: return ViewCube::tr("Left");
    case NamedView::right: return ViewCube::tr("Right");
    case NamedView::top: return ViewCube::tr("Top");
    case NamedView::bottom: return ViewCube::tr("Bottom");
    case NamedView::iso: break;
  }
  return {};
}

QColor mixed(const QColor& a, const QColor& b, double part) {
  return QColor::fromRgbF(a.redF() + part * (b.redF() - a.redF()), a.greenF() + part * (b.greenF() - a.greenF()),
                          a.blueF() + part * (b.blueF() - a.blueF()));
}

}  // namespace

ViewCube::ViewCube(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setObjectName(QStringLiteral("viewCube"));
  setAccessibleName(tr("View cube"));
  setAccessibleDescription(tr("A click on a face shows everything from this side, as Ctrl+1 to Ctrl+6 do"));
  resize(extent, extent);
}

void ViewCube::set_axes(const Eigen::Matrix3d& axes, const Vec3& up) {
  if (axes == axes_ && up == up_) return;
  axes_ = axes;
  up_ = up;
  update();
}

std::vector<ViewCube::Face> ViewCube::faces() const {
  std::vector<Face> seen;
  for (NamedView side : cube_sides) {
    const Vec3 normal = direction_of(side, up_), top = view_up(normal, up_), right = top.cross(normal);
    Face face{side, (axes_ * normal).z(), {}};
    if (face.depth < least_depth) continue;
    for (const auto& [x, y] : {std::pair{-1, 1}, {1, 1}, {1, -1}, {-1, -1}}) {
      const Vec3 at = half_edge * (axes_ * (normal + x * right + y * top));
      face.corners << QPointF(0.5 * extent + at.x(), 0.5 * extent - at.y());
    }
    seen.push_back(face);
  }
  std::sort(seen.begin(), seen.end(), [](const Face& a, const Face& b) { return a.depth < b.depth; });
  return seen;
}

std::optional<NamedView> ViewCube::side_at(const QPoint& at) const {
  if (!isVisibleTo(parentWidget())) return std::nullopt;
  for (const Face& face : faces())
    if (face.corners.containsPoint(at - pos() + QPointF(0.5, 0.5), Qt::OddEvenFill)) return face.side;
  return std::nullopt;
}

std::optional<QPoint> ViewCube::middle_of(NamedView side) const {
  for (const Face& face : faces())
    if (face.side == side) return pos() + (0.5 * (face.corners[0] + face.corners[2])).toPoint();
  return std::nullopt;
}

void ViewCube::set_hovered(std::optional<NamedView> side) {
  if (side == hovered_) return;
  hovered_ = side;
  update();
}

void ViewCube::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor ground = palette().color(QPalette::Base), ink = palette().color(QPalette::WindowText);
  constexpr double edge = 100;
  const QPolygonF square({{0, 0}, {edge, 0}, {edge, edge}, {0, edge}});
  for (const Face& face : faces()) {
    const bool hovered = face.side == hovered_;
    constexpr double darkest = 0.28;  // of a face seen from its edge
    painter.setTransform(QTransform());
    painter.setPen(QPen(mixed(ground, ink, 0.55), 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(hovered ? palette().color(QPalette::Highlight) : mixed(ground, ink, darkest * (1 - face.depth)));
    painter.drawPolygon(face.corners);
    QTransform onto;
    if (!QTransform::quadToQuad(square, face.corners, onto)) continue;
    const QString word = word_on(face.side);
    QFont letters = font();
    letters.setBold(true);
    letters.setPixelSize(30);
    const double wide = QFontMetricsF(letters).horizontalAdvance(word);
    letters.setPixelSize(static_cast<int>(30 * std::min(1.0, 0.88 * edge / std::max(1.0, wide))));
    painter.setTransform(onto);
    painter.setFont(letters);
    painter.setPen(hovered ? palette().color(QPalette::HighlightedText) : ink);
    painter.drawText(QRectF(0, 0, edge, edge), Qt::AlignCenter, word);
  }
}

}  // namespace loopmend
