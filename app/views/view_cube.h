// SPDX-License-Identifier: GPL-3.0-or-later
// A cube in the corner of the picture that turns with it: its faces name the sides. The picture's mouse events find them.
#pragma once

#include "scene/view_direction.h"

#include <Eigen/Core>

#include <QPolygonF>
#include <QWidget>

#include <optional>
#include <vector>

namespace loopmend {

/// Painted over the picture, as axes and scale are: no other picture has it, and it hides no depth from the mouse. VTK's own
/// vtkCameraOrientationWidget knows one up axis only, and draws into the scene.
class ViewCube : public QWidget {
  Q_OBJECT

 public:
  static constexpr int extent = 96;  ///< logical pixels

  explicit ViewCube(QWidget* parent);

  /// @param axes  columns: the axes x, y, z as seen from the eye (x right, y up)
  void set_axes(const Eigen::Matrix3d& axes, const Vec3& up);
  /// The side at this point of the parent.
  std::optional<NamedView> side_at(const QPoint& at) const;
  void set_hovered(std::optional<NamedView> side);
  /// In the parent; nothing where the side faces away.
  std::optional<QPoint> middle_of(NamedView side) const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Face {
    NamedView side;
    double depth;       ///< of its normal, towards the eye
    QPolygonF corners;  ///< as its words run: top left, top right, bottom right, bottom left
  };
  /// Those that face the eye, the farthest first.
  std::vector<Face> faces() const;

  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
  Vec3 up_ = Vec3::UnitY();
  std::optional<NamedView> hovered_;
};

}  // namespace loopmend
