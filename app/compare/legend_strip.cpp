// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/legend_strip.h"

#include "document/labels.h"
#include "panels/parts.h"

#include <QPainter>

namespace loopmend {
namespace {

constexpr int steps = 128;
constexpr double bar_width = 16, gap = 8;

}  // namespace

LegendStrip::LegendStrip(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("compareLegend"));
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
  explain(this, tr("Legend"), tr("The colours of all pictures"));
}

QSize LegendStrip::sizeHint() const {
  QFont bold = font();
  bold.setBold(true);
  return {QFontMetrics(bold).horizontalAdvance(tr("Mean curvature H")) + 24, 200};
}

void LegendStrip::show_range(const Look& look, double half_width) {
  look_ = look;
  half_width_ = half_width;
  setVisible(is_colored(look.shading));
  update();
}

void LegendStrip::set_distance_words(const QString& from, const QString& unit) {
  from_ = from;
  unit_ = unit;
  setAccessibleDescription(QStringLiteral("%1, %2").arg(tr("From %1").arg(from), unit));
  update();
}

void LegendStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paint(painter, rect(), palette().color(QPalette::WindowText));
}

void LegendStrip::paint(QPainter& painter, const QRectF& area, const QColor& ink) const {
  const bool mean = look_.shading != Shading::gaussian, apart = look_.shading == Shading::difference;
  const QFontMetricsF metrics(font());
  const double line = metrics.height();
  QColor soft = ink;
  soft.setAlphaF(0.72);
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  painter.setPen(ink);
  double y = area.top() + 10;
  const auto text = [&](const QString& words, double at) {
    painter.drawText(QRectF(area.left() + gap, at, area.width() - gap, line), Qt::AlignLeft | Qt::AlignVCenter, words);
  };
  text(apart ? tr("From %1").arg(from_) : mean ? tr("Mean curvature H") : tr("Gaussian curv. K"), y);
  painter.setFont(font());
  painter.setPen(soft);
  text(apart ? unit_ : mean ? tr("in 1/length") : tr("in 1/length\u00b2"), y += line);
  text(apart ? tr("outside") : mean ? tr("hollow") : tr("dome or bowl"), y += 1.5 * line);
  const QRectF bar(area.left() + gap, y + line + 4, bar_width,
                   std::max(60.0, std::min(300.0, area.height() - y - 4 * line)));
  for (int i = 0; i < steps; ++i) {
    const Rgb c = color_at(look_.map, 1 - (i + 0.5) / steps);
    painter.fillRect(QRectF(bar.left(), bar.top() + bar.height() * i / steps, bar.width(), bar.height() / steps + 1),
                     QColor::fromRgbF(c[0], c[1], c[2]));
  }
  painter.setPen(ink);
  constexpr int ticks = 5;
  for (int i = 0; i < ticks; ++i) {
    const double t = static_cast<double>(i) / (ticks - 1), value = half_width_ * (1 - 2 * t);
    const double at = bar.top() + t * bar.height();
    painter.drawLine(QPointF(bar.right(), at), QPointF(bar.right() + 4, at));
    const QString sign = value > 0 ? QStringLiteral("+") : value < 0 ? QStringLiteral("\u2212") : QString();
    painter.drawText(QRectF(bar.right() + gap, at - line / 2, area.right() - bar.right() - gap, line),
                     Qt::AlignLeft | Qt::AlignVCenter, sign + labels::number(std::abs(value)));
  }
  painter.setPen(soft);
  text(apart ? tr("inside") : mean ? tr("bulging") : tr("saddle"), bar.bottom() + 6);
}

}  // namespace loopmend
