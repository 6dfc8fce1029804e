// SPDX-License-Identifier: GPL-3.0-or-later
// Shows a plane across a scan, with handles: one moves it along its normal, two turn it.
#pragma once

#include "document/document.h"
#include "jobs/plane_guide.h"
#include "tools/view_tool.h"

#include <Eigen/Geometry>

namespace loopmend {

class PlaneTool : public QObject, public ViewTool {
  Q_OBJECT

 public:
  PlaneTool(const Document& document, PlaneGuide& guide, QObject* parent = nullptr);

  bool mouse(Act act, const QMouseEvent& event, const ViewSpace& space) override;
  void paint(QPainter& painter, const ViewSpace& space) override;

  enum class Handle { none, move, turn_first, turn_second };
  /// Where to take hold of it, logical pixels; for tests.
  QPointF grip(Handle handle, const ViewSpace& space) const;

 Q_SIGNALS:
  void changed();

 private:
  /// The part of the plane that is drawn, scene's frame.
  struct Frame {
    Eigen::Vector3d middle, normal, first, second;  ///< the last two in the plane, as long as half its sides
  };
  Frame frame() const;
  void paint_arrow(QPainter& painter, const ViewSpace& space) const;
  bool has_plane() const;
  void follow();
  Handle handle_at(const QPointF& at, const ViewSpace& space) const;
  void drag(const QPointF& at, const ViewSpace& space);

  const Document& document_;
  PlaneGuide& guide_;
  int boxed_ = -1;           ///< the scan whose box is known
  Eigen::AlignedBox3d box_;  ///< scene's frame
  Handle held_ = Handle::none, hovered_ = Handle::none;
  QPointF pressed_;
  Frame before_{};
};

}  // namespace loopmend
