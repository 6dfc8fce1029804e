// SPDX-License-Identifier: GPL-3.0-or-later
// The one legend beside several pictures.
#pragma once

#include "scene/look.h"

#include <QWidget>

namespace loopmend {

class LegendStrip : public QWidget {
  Q_OBJECT

 public:
  explicit LegendStrip(QWidget* parent = nullptr);
  /// Nothing is painted where the shading has no colours. @param half_width  as in FlowCanvas::set_look.
  void show_range(const Look& look, double half_width);
  /// What distances are from, and their unit; of Shading::difference.
  void set_distance_words(const QString& from, const QString& unit);
  QSize sizeHint() const override;
  void paint(QPainter& painter, const QRectF& area, const QColor& ink) const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Look look_;
  QString from_, unit_;
  double half_width_ = 1;
};

}  // namespace loopmend
