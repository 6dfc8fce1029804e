// SPDX-License-Identifier: GPL-3.0-or-later
// Many points as they appear on the screen: which lie under a brush, within an outline, nearest to the mouse.
#pragma once

#include "tools/view_tool.h"

#include <QPolygonF>

#include <vector>

namespace loopmend {

/// Of p from the segment ab, pixels.
double distance_to_segment(const QPointF& p, const QPointF& a, const QPointF& b);

class ScreenPoints {
 public:
  /// @param xyz       3 × #V, in the scene's frame
  /// @param unseen  #V, those that are not drawn and so never found; empty: none
  void set_points(std::vector<float> xyz, std::vector<char> unseen = {});
  int count() const { return static_cast<int>(xyz_.size() / 3); }
  Eigen::Vector3f point(int i) const { return Eigen::Map<const Eigen::Vector3f>(xyz_.data() + 3 * i); }

  enum class Hidden { left_out, taken };
  /// Within `reach` logical pixels of the way from a to b.
  std::vector<int> under_brush(const ViewSpace& space, const QPointF& a, const QPointF& b, double reach);
  std::vector<int> within(const ViewSpace& space, const QPolygonF& outline, Hidden hidden);
  /// −1 when none that is seen lies within `reach` logical pixels.
  int nearest(const ViewSpace& space, const QPointF& at, double reach);
  /// Logical pixels; a point behind the eye is not finite.
  QPointF on_screen(const ViewSpace& space, int i);
  bool is_seen(const ViewSpace& space, int i);

 private:
  void project(const ViewSpace& space);

  std::vector<float> xyz_;
  std::vector<char> unseen_;
  std::vector<Eigen::Vector3f> pixels_;  ///< device pixels and depth; depth < 0 behind the eye
  Eigen::Matrix4d seen_from_ = Eigen::Matrix4d::Zero();
  int width_ = 0, height_ = 0;
};

}  // namespace loopmend
