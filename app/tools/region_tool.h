// SPDX-License-Identifier: GPL-3.0-or-later
// Brush and lasso: which vertices of one scan, its patches included, make up a region.
#pragma once

#include "document/scene_visibility.h"
#include "tools/screen_points.h"

#include <QObject>

namespace loopmend {

class RegionTool : public QObject, public ViewTool {
  Q_OBJECT

 public:
  RegionTool(const Document& document, const SceneVisibility& visibility, QObject* parent = nullptr);

  enum class Means { brush, lasso };
  enum class Effect { add, erase };
  void set_means(Means means) { means_ = means; }
  void set_effect(Effect effect) { effect_ = effect; }
  /// Of the brush, logical pixels.
  void set_radius(int pixels) { radius_ = pixels; }
  void set_hidden(ScreenPoints::Hidden hidden) { hidden_ = hidden; }

  void clear();
  /// By one ring of triangles.
  void grow();
  void shrink();

  /// Which scan; −1 while nothing is chosen.
  int scan() const { return scan_; }
  /// Points of the scan's soup, its patches' new points after its own; ascending.
  std::vector<int> vertices() const;
  void set_vertices(int scan, const std::vector<int>& points);
  int count() const { return chosen_count_; }
  /// The triangles that would move; null where there are none.
  SurfaceShapePtr shape() const;

  bool mouse(Act act, const QMouseEvent& event, const ViewSpace& space) override;
  void paint(QPainter& painter, const ViewSpace& space) override;

 Q_SIGNALS:
  void changed();
  /// What was painted has gone, since the surface, or what is seen of it, is another.
  void dropped();
  /// What was under the mouse belongs to another scan than what is painted.
  void beside_scan(int painted_scan);

 private:
  void take_surface();
  void forget();
  void drop();
  void choose(const std::vector<int>& found, Effect effect);
  /// Whether the surface shows its outside at this vertex.
  bool shows_outside(const ViewSpace& space, int vertex) const;
  /// Those that show the side that is painted: through a hole, the brush does not reach the wall behind it.
  std::vector<int> on_painted_side(const ViewSpace& space, std::vector<int> found) const;
  void recount();
  enum class Ring { outward, inward };
  void move_edge(Ring ring);

  const Document& document_;
  const SceneVisibility& visibility_;
  bool fresh_ = false;  ///< the arrays are those of the document
  ScreenPoints points_;
  std::vector<int> soup_, scan_of_;
  std::vector<int> triangles_;  ///< 3 × #T
  std::vector<float> normals_;
  std::vector<char> chosen_;
  int chosen_count_ = 0, scan_ = -1;
  Means means_ = Means::brush;
  Effect effect_ = Effect::add, stroke_ = Effect::add;
  ScreenPoints::Hidden hidden_ = ScreenPoints::Hidden::left_out;
  int radius_ = 24;
  bool outside_ = true;  ///< the side that is painted: that of what is nearest to the eye
  QPolygonF outline_;
  QPointF at_{-1000, -1000};
};

}  // namespace loopmend
