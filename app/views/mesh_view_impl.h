// SPDX-License-Identifier: GPL-3.0-or-later
// Private to MeshView: what its two source files share.
#pragma once

#include "document/document.h"
#include "document/hole_selection.h"
#include "scene/mesh_scene.h"
#include "views/camera_flight.h"
#include "views/loop_picker.h"
#include "views/mesh_view.h"
#include "views/scan_ranges.h"
#include "views/shown_shapes.h"
#include "views/surface_probe.h"
#include "views/tool_sheet.h"
#include "views/turn_style.h"
#include "views/view_cube.h"
#include "views/view_overlay.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QElapsedTimer>
#include <QPushButton>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <optional>

namespace loopmend {

/// A ball, in the scene's frame.
struct MarkedPlace {
  Vec3 center;
  double radius;
};

struct MeshView::Impl {
  Impl(const Document& d, SceneVisibility& v, HoleSelection& s) : document(d), visibility(v), selection(s) {}

  const Document& document;
  SceneVisibility& visibility;
  HoleSelection& selection;
  QVTKOpenGLNativeWidget* canvas = nullptr;
  ViewOverlay* overlay = nullptr;
  ToolSheet* sheet = nullptr;
  ViewCube* cube = nullptr;
  CameraFlight* flight = nullptr;
  QPushButton* hidden_note = nullptr;  ///< says what is hidden, and shows it
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  MeshScene scene;
  ShownShapes shapes;
  LoopPicker picker;
  QTimer redraw_timer;
  QElapsedTimer last_picture, last_move;  ///< of the camera
  int covered = 0;                        ///< see set_covered()
  int pause_ms = 0;                       ///< after a picture, before the next
  vtkNew<vtkFloatArray> depth;
  vtkMTimeType seen_camera = 0;
  QSize seen_size;
  bool depth_is_fresh = false;
  QPoint pressed_at;
  std::optional<QPoint> mouse_at;  ///< while it is over the picture
  Look look;
  std::optional<Probe> probe;
  ScanRanges scan_ranges;
  std::map<int, double> ranges;  ///< of scans whose colours have one of their own
  bool preview_shown = false;
  std::optional<MarkedPlace> place;  ///< the last one flown to of what show_marked() shows
  bool fresh_scene = true;           ///< nothing of it has been seen yet: the eye may go where it likes
  ProblemPicture trial;
  std::set<int> hidden_loops;  ///< whose patches others are shown for
  std::vector<SurfaceShapePtr> instead;
  Clipping clipping;
  Vec3 line_of_sight = -Vec3::UnitZ();                  ///< when it was chosen to clip across
  std::optional<NamedView> hovered_side, pressed_side;  ///< of the cube
  std::shared_ptr<TurnRules> turning = std::make_shared<TurnRules>();
  ViewTool* tool = nullptr;
  bool tool_has_mouse = false;
  bool drawing_elsewhere = false;      ///< into a picture, not onto the screen
  CameraPose pose_before;              ///< of the preview
  CameraPose framed;                   ///< as Frame left it
  std::vector<LoopStyle> loop_styles;  ///< as drawn

  bool is_replaced(const OpenPatch& patch) const { return hidden_loops.contains(patch.loops.front()); }
  vtkRenderer* renderer() const { return scene.renderer(); }
  vtkCamera* camera() const { return renderer()->GetActiveCamera(); }
  /// Whether the loop is in the scene, and shown.
  bool shows(int loop) const { return document.present(loop) && !visibility.is_hidden_loop(loop); }
  /// How long to wait until the camera counts as resting, ms; 0: it rests.
  int time_to_rest() const {
    constexpr qint64 rest_ms = 150;
    return last_move.isValid() ? static_cast<int>(std::max<qint64>(0, rest_ms - last_move.elapsed())) : 0;
  }
  QSize pixels() const { return canvas->size() * canvas->devicePixelRatioF(); }

  void follow_camera() {
    const QSize size = pixels();
    if (camera()->GetMTime() == seen_camera && size == seen_size) return;
    seen_camera = camera()->GetMTime();
    seen_size = size;
    depth_is_fresh = false;
    picker.set_view(to_clip(), size.width(), size.height());
    const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> turn(
        camera()->GetModelViewTransformMatrix()->GetData());
    if (!document.has_scan()) return;
    overlay->set_axes(turn.block<3, 3>(0, 0));
    cube->set_axes(turn.block<3, 3>(0, 0), turning->up());
    constexpr double degree = 3.14159265358979323846 / 180;
    const double seen_height = 2 * camera()->GetDistance() * std::tan(0.5 * camera()->GetViewAngle() * degree);
    overlay->set_scale(seen_height / std::max(1, canvas->height()));
  }

  /// From world to OpenGL clip space, for the canvas as it is.
  Eigen::Matrix4d to_clip() const {
    const QSize size = pixels();
    const double aspect = static_cast<double>(size.width()) / std::max(1, size.height());
    return Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(
        camera()->GetCompositeProjectionTransformMatrix(aspect, -1, 1)->GetData());
  }

  float depth_at(int x, int y) {
    if (!depth_is_fresh) {
      canvas->makeCurrent();
      window->GetZbufferData(0, 0, seen_size.width() - 1, seen_size.height() - 1, depth);
      depth_is_fresh = true;
    }
    const vtkIdType at = static_cast<vtkIdType>(seen_size.height() - 1 - y) * seen_size.width() + x;
    return at < depth->GetNumberOfValues() ? depth->GetValue(at) : 1;
  }

  double aspect() const { return static_cast<double>(canvas->width()) / std::max(1, canvas->height()); }
};

}  // namespace loopmend
