// SPDX-License-Identifier: GPL-3.0-or-later
// Something that takes the mouse in the picture: a brush, a picker, a handle to move a part by.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include <QPointF>

#include <functional>
#include <optional>

class QMouseEvent;
class QPainter;

namespace loopmend {

/// How the scene comes onto the screen at this moment.
struct ViewSpace {
  Eigen::Matrix4d to_clip = Eigen::Matrix4d::Identity();  ///< from the scene's frame to OpenGL clip space
  int width = 1, height = 1;                              ///< device pixels
  double ratio = 1;                                       ///< device pixels per logical pixel
  std::function<float(int x, int y)> depth_at;            ///< of what is drawn, 0..1; device pixels, y down

  /// Device pixels and depth; depth < 0 behind the eye.
  Eigen::Vector3d to_screen(const Eigen::Vector3d& point) const {
    const Eigen::Vector4d clip = to_clip * Eigen::Vector4d(point.x(), point.y(), point.z(), 1);
    if (clip.w() <= 0) return {0, 0, -1};
    const Eigen::Vector3d n = clip.head<3>() / clip.w();
    return {(n.x() + 1) / 2 * width, (1 - n.y()) / 2 * height, (n.z() + 1) / 2};
  }

  /// What is drawn there, in the scene's frame; none beside everything. @param at  logical pixels
  std::optional<Eigen::Vector3d> surface_at(const QPointF& at) const {
    const double x = (at.x() + 0.5) * ratio, y = (at.y() + 0.5) * ratio;
    const double depth = static_cast<double>(depth_at(static_cast<int>(x), static_cast<int>(y)));
    if (depth >= 1) return std::nullopt;
    const Eigen::Vector4d clip(2 * x / width - 1, 1 - 2 * y / height, 2 * depth - 1, 1);
    const Eigen::Vector4d point = to_clip.inverse() * clip;
    return point.head<3>() / point.w();
  }
};

class ViewTool {
 public:
  virtual ~ViewTool() = default;

  enum class Act { press, move, release, hover };
  /// @returns whether the tool took it; otherwise the picture turns, and boundaries are picked, as without a tool.
  virtual bool mouse(Act act, const QMouseEvent& event, const ViewSpace& space) = 0;
  /// Over the picture, in logical pixels.
  virtual void paint(QPainter& painter, const ViewSpace& space) = 0;
};

}  // namespace loopmend
