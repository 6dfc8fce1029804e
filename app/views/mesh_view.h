// SPDX-License-Identifier: GPL-3.0-or-later
// The picture in the middle: shows the document, finds the loop under the mouse, turns, flies.
#pragma once

#include "document/navigation.h"
#include "document/scene_visibility.h"
#include "scene/clipping.h"
#include "scene/look.h"
#include "scene/shape_glide.h"
#include "scene/trial_picture.h"
#include "scene/view_direction.h"
#include "tools/view_tool.h"

#include <QImage>
#include <QPolygonF>
#include <QWidget>

#include <map>
#include <memory>
#include <optional>
#include <set>

namespace loopmend {

class HoleSelection;

struct MarkedPlace;
struct SurfacePlace;

/// A picture that leaves the program.
struct PictureOptions {
  QSize size;  ///< device pixels, 64..8192 each
  enum class Ground { as_seen, transparent } ground = Ground::as_seen;
  enum class Extras { none, legend, legend_axes_scale } extras = Extras::legend_axes_scale;
  int outlined = -1;  ///< loop whose boundary is drawn, and no other; −1: the boundaries as the view has them
};

class MeshView : public QWidget {
  Q_OBJECT

 public:
  /// To be called once, before the QApplication is made.
  static void prepare_graphics();

  MeshView(const Document& document, SceneVisibility& visibility, HoleSelection& selection, QWidget* parent = nullptr);
  ~MeshView() override;

  const Look& look() const;
  void set_look(const Look& look);
  /// Half-width of the colour range in force.
  double range() const;
  /// That of a scan's colours.
  double range_of(int scan) const;

  /// Something lies over the top of the picture, so many pixels high: the legend makes room.
  void set_covered(int height);
  /// A first picture of a scan that is still being opened.
  void show_preview(SurfaceShapePtr shape);
  void drop_preview();
  /// Patches that are only thought of.
  void show_ghosts(const std::vector<SurfaceShapePtr>& ghosts);
  /// Other patches in place of what closes these loops, as long as the mouse is over their card; without loops: as it is.
  void show_instead(const std::set<int>& loops, const std::vector<SurfaceShapePtr>& shapes);
  /// The boundary's vertices, in the scene's frame.
  std::vector<float> line_of_loop(int loop) const;

  Viewpoint viewpoint() const;
  void set_viewpoint(const Viewpoint& viewpoint);
  /// From where the loop is seen from above. It must be present.
  Viewpoint viewpoint_above(int loop) const;
  /// A part of a surface that was painted; null: none.
  void show_marked(SurfaceShapePtr shape);
  /// In place of scans and their patches; an empty picture shows these again.
  void show_trial(const ProblemPicture& picture);
  /// Takes the mouse first; null: none. Stays alive as long as it is set.
  void set_tool(ViewTool* tool);
  /// What the tool paints over the picture is another.
  void update_tool();
  ViewSpace space();
  void place_scan(int scan, const Eigen::Matrix4d& placement);

  /// The line of sight is that of now.
  void set_clipping(const Clipping& clipping);
  enum class Projection { perspective, orthographic };
  void set_projection(Projection projection);
  /// What the mouse does to the picture.
  void set_navigation(NavigationStyle style);
  /// A unit vector: as chosen in look(), else as the shape of the scene has it.
  Vec3 up() const;
  /// Everything, from this side.
  void look_from(NamedView side);
  /// The same, after a short flight.
  void fly_to_side(NamedView side);
  /// Everything, from where the eye is.
  void frame();
  /// Turns and moves until the loop is seen from above. What hides it is shown.
  void fly_to(int loop);
  /// Flies to the widest of the loops, unless one of them is seen from above already.
  void fly_to_unseen(const std::set<int>& loops);
  /// The same for a ball, in the scene's frame. @param direction  towards the eye, unit
  void fly_to_place(const Vec3& center, double radius, const Vec3& direction);
  bool is_flying() const;

  /// As seen, without overlay, in device pixels.
  QImage picture() const;
  /// Drawn again at another size. Null when the graphics cannot draw that much.
  QImage picture(const PictureOptions& options);
  /// Whether large scans are still reduced in it, or as they were before: pictures will follow.
  bool is_rough() const;
  /// The values at the middle of the picture.
  void probe_middle();
  void drop_probe();
  /// The piece of surface under the mouse; none beside everything.
  std::optional<PieceId> piece_under_mouse();

  /// Where a loop's vertex appears, in widget pixels; for tests.
  QPoint position_of(int loop, int vertex) const;
  /// The widget that takes the mouse; for tests.
  QWidget* canvas() const;

 Q_SIGNALS:
  void probed(const QString& words);
  /// A right click on a boundary, which is selected now. @param at  of the screen
  void hole_menu_wanted(const QPoint& at);
  /// A right click on a surface. @param at  of the screen
  void piece_menu_wanted(const PieceId& piece, const QPoint& at);
  /// A picture is on the screen.
  void drawn();
  /// look() is another.
  void look_set();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Impl;
  void follow_document();
  void on_scans_changed();
  void update_colors();
  void update_range();
  double range_of_patches(double percent) const;
  void use_ranges(double half_width, const std::map<int, double>& of_scans);
  int legend_scan() const;
  void update_legend_words();
  void on_patches_changed();
  void on_visibility_changed();
  void update_hidden_note();
  void on_patch_moved(int id);
  Arrival arrival(int patch) const;
  void show_surfaces();
  bool cube_takes(QEvent* event);
  bool tool_takes(QEvent* event);
  /// @returns whether they look otherwise now, and are to be drawn.
  bool update_loops();
  void update_highlight();
  void update_marks();
  QPolygonF line_on_screen(int loop) const;
  QRectF box_on_screen(const MarkedPlace& place) const;
  void update_palette();
  void hover(const QPoint& at);
  void ask_for_menu(const QPoint& at);
  void click(const QPoint& at, Qt::KeyboardModifiers modifiers);
  void probe_at(const QPoint& at);
  std::optional<SurfacePlace> place_at(const QPoint& at);
  void update_probe();
  bool slide_by_key(int key);
  void move_by_key(int key, Qt::KeyboardModifiers modifiers);
  int loop_at(const QPoint& at);
  int loop_around(const QPoint& at);
  void face_front();
  /// Frames the scene again unless it was turned since: the room for it is another.
  void frame_if_untouched();
  void redraw();
  void redraw_at_leisure();
  void redraw_at_rest();
  void after_render();

  std::unique_ptr<Impl> impl_;
};

}  // namespace loopmend
