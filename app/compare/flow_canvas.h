// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of one flow's patch in its neighborhood; or of two, left and right of a line that can be drawn.
#pragma once

#include "scene/look.h"
#include "scene/loop_lines.h"
#include "scene/shape_glide.h"
#include "views/camera_flight.h"
#include "views/mesh_view.h"

#include <QImage>
#include <QWidget>

#include <memory>

namespace loopmend {

class PictureClock;
struct SurfaceShape;

class FlowCanvas : public QWidget {
  Q_OBJECT

 public:
  enum class Sides { one, two };
  /// @param clock  lives longer; says when to draw.
  FlowCanvas(const char* name, Sides sides, PictureClock& clock, QWidget* parent = nullptr);
  ~FlowCanvas() override;

  void set_neighborhood(std::shared_ptr<const SurfaceShape> shape);
  /// Drawn as lines where the look has them.
  void set_seams(const std::vector<LoopLine>& lines);
  /// @param side  0, or 1 for what is right of the line.
  void show_patch(int side, std::shared_ptr<const SurfaceShape> shape, Arrival arrival = Arrival::at_once);
  /// A flow starts: the time until its first state says how long the surface moves to it.
  void expect_news();
  /// @param half_width  of the colour range, in force instead of the look's own.
  void set_look(const Look& look, double half_width);

  CameraPose pose() const;
  void set_pose(const CameraPose& pose);
  /// A sphere to be seen whole, in the frame of what is shown. @param towards_eye  unit; zero: from where the eye is.
  void look_at(const Eigen::Vector3d& middle, double radius, const Eigen::Vector3d& towards_eye);

  /// Where the line stands, 0..1 of the width.
  double line() const;
  void set_line(double share);

  /// When the clock says so: several requests make one picture.
  void redraw();
  /// Now; for the clock.
  void draw();
  /// Drawn again at another size, device pixels. Null when the graphics cannot.
  QImage picture(const QSize& size, PictureOptions::Ground ground = PictureOptions::Ground::as_seen);
  QWidget* canvas() const;
  /// For tests and measurements: how many pictures were drawn so far, how many of them kept the neighborhood for the
  /// next ones, and whether the patch is between two states.
  int frames() const;
  int neighborhood_drawn() const;
  bool is_moving() const;

 Q_SIGNALS:
  /// The person has turned or moved it.
  void turned();
  void line_moved();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Impl;
  void before_drawing();
  void update_palette();
  void place_sides();
  bool drag_line(QEvent* event);

  std::unique_ptr<Impl> impl_;
};

}  // namespace loopmend
