// SPDX-License-Identifier: GPL-3.0-or-later
// Shows the sharp edges that run on across holes: a click on one removes it, two boundary vertices draw one.
#pragma once

#include "jobs/edge_guide.h"
#include "tools/bridge_tool.h"

namespace loopmend {

class EdgesTool : public QObject, public ViewTool {
  Q_OBJECT

 public:
  EdgesTool(const Document& document, const SceneVisibility& visibility, EdgeGuide& guide, QObject* parent = nullptr);

  bool is_begun() const { return ends_.is_begun(); }
  void clear();

  bool mouse(Act act, const QMouseEvent& event, const ViewSpace& space) override;
  void paint(QPainter& painter, const ViewSpace& space) override;
  /// The middle of an edge, logical pixels. For tests.
  QPointF middle_of(std::size_t edge, const ViewSpace& space) const;
  /// As of the tool for bridges.
  QPointF position_of(int scan, int soup_point, const ViewSpace& space) {
    return ends_.position_of(scan, soup_point, space);
  }

 Q_SIGNALS:
  void changed();

 private:
  /// The edge under the mouse; −1: none.
  int edge_at(const QPointF& at, const ViewSpace& space) const;

  EdgeGuide& guide_;
  BridgeTool ends_;
  int hovered_ = -1;
};

}  // namespace loopmend
