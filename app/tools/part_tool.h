// SPDX-License-Identifier: GPL-3.0-or-later
// A handle in the picture by which a part is moved, turned and scaled.
#pragma once

#include "document/document.h"
#include "tools/view_tool.h"

#include <Eigen/Geometry>
#include <QObject>
#include <QPointF>

namespace loopmend {

class PartTool : public QObject, public ViewTool {
  Q_OBJECT

 public:
  explicit PartTool(const Document& document, QObject* parent = nullptr);

  /// Which scan the handle holds; −1: none. The placement begins again.
  void set_scan(int scan);
  int scan() const { return scan_; }
  /// In the scene's frame; identity while nothing was moved.
  const Eigen::Affine3d& placement() const { return placement_; }
  void set_placement(const Eigen::Affine3d& placement);
  bool is_moved() const { return !placement_.matrix().isIdentity(1e-12); }

  enum class Handle { none, move_x, move_y, move_z, turn_x, turn_y, turn_z, slide, scale };
  /// Where to take hold of a handle, logical pixels; for tests.
  QPointF grip(Handle handle, const ViewSpace& space) const;

  bool mouse(Act act, const QMouseEvent& event, const ViewSpace& space) override;
  void paint(QPainter& painter, const ViewSpace& space) override;

 Q_SIGNALS:
  /// While the mouse moves it.
  void placed();
  /// The mouse has let go.
  void released();

 private:
  Eigen::Vector3d middle() const { return placement_ * middle_; }
  double reach(const ViewSpace& space) const;
  std::vector<QPointF> ring(int axis, const ViewSpace& space) const;
  Handle handle_at(const QPointF& at, const ViewSpace& space) const;
  void drag(const QPointF& at, const ViewSpace& space);

  const Document& document_;
  int scan_ = -1;
  Eigen::Vector3d middle_ = Eigen::Vector3d::Zero();  ///< of the part as it was, scene's frame
  Eigen::Affine3d placement_ = Eigen::Affine3d::Identity(), placement_before_ = Eigen::Affine3d::Identity();
  Handle held_ = Handle::none, hovered_ = Handle::none;
  QPointF pressed_;
};

}  // namespace loopmend
