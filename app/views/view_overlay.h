// A transparent sheet over the picture: the loop under the mouse, the axes, and words while nothing is open.
#pragma once

#include <Eigen/Core>

#include <QPolygonF>
#include <QWidget>

namespace loopmend {

class ViewOverlay : public QWidget {
  Q_OBJECT

 public:
  explicit ViewOverlay(QWidget* parent);

  void set_highlight(const QPolygonF& loop, const QString& caption);
  void clear_highlight();
  /// Columns: the axes x, y, z as seen from the eye (x right, y up).
  void set_axes(const Eigen::Matrix3d& axes);
  void hide_axes();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paint_highlight(QPainter& painter) const;
  void paint_axes(QPainter& painter) const;

  QPolygonF loop_;
  QString caption_;
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
  bool with_axes_ = false;
};

}  // namespace loopmend
