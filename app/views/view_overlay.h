// SPDX-License-Identifier: GPL-3.0-or-later
// A transparent sheet over the picture: the loop under the mouse, marks around patches, a probed point, the axes, the scale bar.
#pragma once

#include <Eigen/Core>

#include <QPolygonF>
#include <QRegion>
#include <QWidget>

#include <vector>

namespace loopmend {

class ViewOverlay : public QWidget {
  Q_OBJECT

 public:
  explicit ViewOverlay(QWidget* parent);

  void set_highlight(const QPolygonF& loop, const QString& caption);
  void clear_highlight();
  const QString& caption() const { return caption_; }
  /// Corners around a patch: they name it and leave its seam clear.
  struct Mark {
    QRectF box;  ///< of the patch's boundary
    enum class Side { seen, from_behind } side = Side::seen;
    bool operator==(const Mark&) const = default;
  };
  void set_marks(const std::vector<Mark>& marks);
  const std::vector<Mark>& marks() const { return marks_; }
  void set_probe(const QPointF& at, const QStringList& lines);
  void clear_probe();
  /// Columns: the axes x, y, z as seen from the eye (x right, y up).
  void set_axes(const Eigen::Matrix3d& axes);
  /// How long a pixel is at the distance of what is looked at, in the scan's unit.
  void set_scale(double length_per_pixel);
  /// Stands behind the length of the scale; may be empty.
  void set_unit(const QString& symbol);
  void hide_axes();

  /// Axes and scale bar alone, for pictures; in the sheet's own pixels.
  void paint_frame(QPainter& painter) const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QRegion around_highlight() const;
  void paint_highlight(QPainter& painter) const;
  QRegion around_marks() const;
  void paint_marks(QPainter& painter) const;
  void paint_probe(QPainter& painter) const;
  void paint_axes(QPainter& painter) const;
  void paint_scale(QPainter& painter) const;

  QPolygonF loop_;
  QString caption_;
  std::vector<Mark> marks_;
  QPointF probe_;
  QStringList probe_lines_;
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
  QString unit_;
  double length_per_pixel_ = 0;
  bool with_axes_ = false;
};

}  // namespace loopmend
