// SPDX-License-Identifier: GPL-3.0-or-later
// Picks the two boundary vertices between which a bridge is laid.
#pragma once

#include "document/scene_visibility.h"
#include "tools/screen_points.h"

#include <QObject>

namespace loopmend {

class BridgeTool : public QObject, public ViewTool {
  Q_OBJECT

 public:
  BridgeTool(const Document& document, const SceneVisibility& visibility, QObject* parent = nullptr);

  /// The soup point of the first of the two vertices; −1 while none is picked.
  int begun_point() const { return begun_ < 0 ? -1 : seats_[static_cast<std::size_t>(begun_)].soup_point; }
  bool is_begun() const { return begun_point() >= 0; }
  void clear();

  bool mouse(Act act, const QMouseEvent& event, const ViewSpace& space) override;
  void paint(QPainter& painter, const ViewSpace& space) override;
  /// Where a boundary vertex appears, logical pixels; (−1, −1) where it is none. For tests.
  QPointF position_of(int scan, int soup_point, const ViewSpace& space);

 Q_SIGNALS:
  void changed();
  void bridge_wanted(int scan, int soup_a, int soup_b);

 private:
  /// A vertex of an open loop.
  struct Seat {
    int scan = 0, soup_point = 0;
    bool operator==(const Seat&) const = default;
  };
  void forget();
  void take_loops();

  const Document& document_;
  const SceneVisibility& visibility_;
  bool fresh_ = false;
  ScreenPoints points_;
  std::vector<Seat> seats_;
  QPointF at_;
  int hovered_ = -1, begun_ = -1;
};

}  // namespace loopmend
