// SPDX-License-Identifier: GPL-3.0-or-later
// Shows the plane of symmetry of a scan, with handles: one moves it along its normal, two turn it.
#pragma once

#include "jobs/mirror_guide.h"
#include "tools/view_tool.h"

#include <Eigen/Geometry>

namespace loopmend {

class MirrorTool : public QObject, public ViewTool {
  Q_OBJECT

 public:
  MirrorTool(const Document& document, MirrorGuide& guide, QObject* parent = nullptr);

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
  bool has_plane() const;
  void follow();
  Handle handle_at(const QPointF& at, const ViewSpace& space) const;
  void drag(const QPointF& at, const ViewSpace& space);

  const Document& document_;
  MirrorGuide& guide_;
  int boxed_ = -1;           ///< the scan whose box is known
  Eigen::AlignedBox3d box_;  ///< scene's frame
  Handle held_ = Handle::none, hovered_ = Handle::none;
  QPointF pressed_;
  Frame before_{};
};

}  // namespace loopmend
