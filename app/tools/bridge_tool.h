// SPDX-License-Identifier: GPL-3.0-or-later
// Picks the two boundary vertices between which a bridge is laid, a part of a hole is filled, or an edge runs.
#pragma once

#include "document/scene_visibility.h"
#include "pipeline/hand_bridge.h"
#include "tools/screen_points.h"

#include <QObject>

#include <memory>
#include <optional>

namespace loopmend {

class BridgeTool : public QObject, public ViewTool {
  Q_OBJECT

 public:
  BridgeTool(const Document& document, const SceneVisibility& visibility, QObject* parent = nullptr);

  enum class Purpose {
    bridge,
    fill_part,  ///< both on one loop; the shorter part of it is filled, with Ctrl the longer one
    edge,       ///< both on one loop
  };
  void set_purpose(Purpose purpose);

  /// The soup point of the first of the two vertices; −1 while none is picked.
  int begun_point() const { return begun_ < 0 ? -1 : seats_[begun_].soup_point; }
  bool is_begun() const { return begun_point() >= 0; }
  bool is_hovering() const { return hovered_ >= 0; }
  void clear();
  /// Soup points of the part that is lit: it would be filled by a click. Empty: none.
  std::vector<int> lit_points() const;
  /// The strip that a click would lay; none where the two vertices allow none.
  const std::optional<BridgeStrip>& strip() const { return strip_; }
  /// That side of it at which the hole stays open, as it is drawn; mesh units. Empty: no part is lit.
  std::vector<Vec3> new_edge() const;

  bool mouse(Act act, const QMouseEvent& event, const ViewSpace& space) override;
  void paint(QPainter& painter, const ViewSpace& space) override;
  /// Where a boundary vertex appears, logical pixels; (−1, −1) where it is none. For tests.
  QPointF position_of(int scan, int soup_point, const ViewSpace& space);

 Q_SIGNALS:
  void changed();
  void bridge_wanted(int scan, int soup_a, int soup_b);
  void edge_wanted(int scan, int soup_a, int soup_b);
  /// @param beside  soup point, in the middle of the part that is to be filled
  void part_wanted(int scan, int soup_a, int soup_b, int beside);

 private:
  /// A vertex of an open loop.
  struct Seat {
    int scan = 0, soup_point = 0;
    int loop = 0, first = 0, count = 0;  ///< of the document; the seats of the loop are first, first + 1, ...
    bool operator==(const Seat&) const = default;
  };
  void forget();
  void take_loops();
  /// The seats of the part that would be filled between the first vertex and the one under the mouse; empty: none.
  std::vector<int> part() const;
  double length(int seat, int steps) const;
  /// Whether the lit part runs from the first vertex on, and not from the second.
  bool is_forward() const;
  /// Of what a click would do now.
  void find_strip();
  enum class Side { left, right };
  std::vector<Vec3> side_of_strip(Side side) const;
  void paint_strip(QPainter& painter, const ViewSpace& space) const;

  const Document& document_;
  const SceneVisibility& visibility_;
  bool fresh_ = false;
  ScreenPoints points_;
  std::vector<Seat> seats_;
  QPointF at_;
  int hovered_ = -1, begun_ = -1;
  Purpose purpose_ = Purpose::bridge;
  bool longer_ = false;                        ///< Ctrl is held
  std::shared_ptr<const SurfaceModel> model_;  ///< of the maker
  std::unique_ptr<BridgeMaker> maker_;         ///< of the first vertex's scan
  std::optional<BridgeStrip> strip_;
  int strip_to_ = -1;  ///< the seat that strip_ is for
};

}  // namespace loopmend
