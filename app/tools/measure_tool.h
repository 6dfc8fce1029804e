// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the distance of two vertices that are clicked.
#pragma once

#include "core/types.h"
#include "tools/view_tool.h"

#include <QObject>

#include <functional>
#include <optional>
#include <vector>

namespace loopmend {

class MeasureTool : public QObject, public ViewTool {
  Q_OBJECT

 public:
  /// The vertex nearest to a point on a surface, both in the scene's frame; none where nothing is open.
  using Snap = std::function<std::optional<Vec3>(const Vec3& at)>;

  explicit MeasureTool(Snap snap, QObject* parent = nullptr);

  bool is_begun() const { return !ends_.empty(); }
  /// From the first end to the second, in mesh units; none before both are known.
  std::optional<Vec3> way() const;
  void clear();

  bool mouse(Act act, const QMouseEvent& event, const ViewSpace& space) override;
  void paint(QPainter& painter, const ViewSpace& space) override;

 Q_SIGNALS:
  void changed();

 private:
  Snap snap_;
  std::vector<Vec3> ends_;  ///< at most two, in the scene's frame
  QPointF at_;
};

}  // namespace loopmend
