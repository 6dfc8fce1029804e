// SPDX-License-Identifier: GPL-3.0-or-later
// Picks the vertices of a polyhedron that stay where they are: one by one, or by a box.
#pragma once

#include "document/scene_visibility.h"
#include "tools/screen_points.h"

#include <QObject>

namespace loopmend {

class PointsTool : public QObject, public ViewTool {
  Q_OBJECT

 public:
  PointsTool(const Document& document, const SceneVisibility& visibility, QObject* parent = nullptr);

  enum class Choice { all, picked };
  void set_choice(Choice choice);
  Choice choice() const { return choice_; }
  void clear();

  /// The scan whose vertices are meant: the one picked in last, or the first.
  int scan() const;
  void set_scan(int scan);
  /// Soup points, ascending; empty for all.
  std::vector<int> fixed() const;
  int count() const;

  bool mouse(Act act, const QMouseEvent& event, const ViewSpace& space) override;
  void paint(QPainter& painter, const ViewSpace& space) override;
  /// Where a vertex of the scan appears, logical pixels; for tests.
  QPointF position_of(int soup_point, const ViewSpace& space);

 Q_SIGNALS:
  void changed();

 private:
  void take_surface();
  void forget();

  const Document& document_;
  const SceneVisibility& visibility_;
  bool fresh_ = false;
  int scan_ = -1;
  Choice choice_ = Choice::all;
  ScreenPoints points_;
  std::vector<int> soup_;
  std::vector<char> fixed_;
  QPointF pressed_, at_;
  bool boxing_ = false;
  int hovered_ = -1;
};

}  // namespace loopmend
