// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/mesh_view_impl.h"

#include <vtkUnsignedCharArray.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

namespace loopmend {
namespace {

constexpr double pick_reach = 9;    ///< logical pixels
constexpr int click_slack = 4;      ///< a press that moves less is a click
constexpr double loop_share = 2.4;  ///< how many loop diameters are seen around a loop flown to

}  // namespace

bool MeshView::eventFilter(QObject* watched, QEvent* event) {
  if (watched != impl_->canvas) return QWidget::eventFilter(watched, event);
  if (event->type() == QEvent::MouseMove) impl_->mouse_at = static_cast<QMouseEvent*>(event)->pos();
  if (event->type() == QEvent::Leave) impl_->mouse_at.reset();
  if (cube_takes(event) || (impl_->tool && tool_takes(event))) return true;
  switch (event->type()) {
    case QEvent::MouseMove: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      if (mouse->buttons() == Qt::NoButton) hover(mouse->pos());
      break;
    }
    case QEvent::MouseButtonPress:
      impl_->pressed_at = static_cast<QMouseEvent*>(event)->pos();
      impl_->flight->stop();
      impl_->selection.hover(no_loop);
      break;
    case QEvent::MouseButtonRelease: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      const bool still = (mouse->pos() - impl_->pressed_at).manhattanLength() <= click_slack;
      if (still && mouse->button() == Qt::LeftButton) click(mouse->pos(), mouse->modifiers());
      if (still && mouse->button() == Qt::RightButton) ask_for_menu(mouse->pos());
      break;
    }
    case QEvent::MouseButtonDblClick: {
      const int loop = loop_at(static_cast<QMouseEvent*>(event)->pos());
      if (loop != no_loop) fly_to(loop);
      break;
    }
    case QEvent::KeyPress: {
      const auto* pressed = static_cast<QKeyEvent*>(event);
      move_by_key(pressed->key(), pressed->modifiers());
      break;
    }
    case QEvent::Leave: impl_->selection.hover(no_loop); break;
    case QEvent::Wheel: impl_->flight->stop(); break;
    default: break;
  }
  return QWidget::eventFilter(watched, event);
}

void MeshView::ask_for_menu(const QPoint& at) {
  const QPoint on_screen = impl_->canvas->mapToGlobal(at);
  int loop = loop_at(at);
  if (loop == no_loop) loop = loop_around(at);
  if (loop != no_loop) {
    if (!impl_->selection.selected().contains(loop)) impl_->selection.select({loop});
    Q_EMIT hole_menu_wanted(on_screen);
  } else if (const auto place = place_at(at)) {
    Q_EMIT piece_menu_wanted(piece_at(impl_->document, impl_->visibility, *place), on_screen);
  }
}

bool MeshView::tool_takes(QEvent* event) {
  using Act = ViewTool::Act;
  const auto type = event->type();
  if (type != QEvent::MouseMove && type != QEvent::MouseButtonPress && type != QEvent::MouseButtonRelease) return false;
  const auto& mouse = *static_cast<QMouseEvent*>(event);
  // With a tool in hand Shift turns the picture: motion_of().
  if (mouse.modifiers().testFlag(Qt::ShiftModifier) && !impl_->tool_has_mouse) return false;
  bool taken = false;
  if (type == QEvent::MouseButtonPress) {
    taken = impl_->tool_has_mouse = impl_->tool->mouse(Act::press, mouse, space());
    if (taken) impl_->flight->stop();
  } else if (type == QEvent::MouseMove) {
    const bool dragging = impl_->tool_has_mouse;
    if (dragging || mouse.buttons() == Qt::NoButton)
      taken = impl_->tool->mouse(dragging ? Act::move : Act::hover, mouse, space()) || dragging;
  } else {
    taken = std::exchange(impl_->tool_has_mouse, false);
    if (taken) impl_->tool->mouse(Act::release, mouse, space());
  }
  if (taken) impl_->selection.hover(no_loop);
  update_tool();
  return taken;
}

void MeshView::set_tool(ViewTool* tool) {
  impl_->tool = tool;
  impl_->turning->hand = tool ? Hand::tool : Hand::empty;
  impl_->tool_has_mouse = false;
  impl_->sheet->setVisible(tool != nullptr);
  impl_->sheet->setGeometry(rect());
  impl_->sheet->raise();
  impl_->canvas->unsetCursor();
  update_tool();
}

void MeshView::update_tool() {
  if (impl_->tool) impl_->sheet->update();
}

ViewSpace MeshView::space() {
  impl_->follow_camera();
  const QSize size = impl_->pixels();
  return {impl_->to_clip(), size.width(), size.height(), impl_->canvas->devicePixelRatioF(),
          [this](int x, int y) { return impl_->depth_at(x, y); }};
}

int MeshView::loop_at(const QPoint& at) {
  if (!impl_->document.has_scan() || impl_->picker.count() == 0) return no_loop;
  impl_->follow_camera();
  const double ratio = impl_->canvas->devicePixelRatioF();
  const int loop = impl_->picker.pick((at.x() + 0.5) * ratio, (at.y() + 0.5) * ratio, pick_reach * ratio,
                                      [this](int x, int y) { return impl_->depth_at(x, y); });
  return loop < 0 ? no_loop : loop;
}

/// A hole or a patch, not the outline of what lies there.
int MeshView::loop_around(const QPoint& at) {
  if (!impl_->document.has_scan() || impl_->picker.count() == 0) return no_loop;
  const double ratio = impl_->canvas->devicePixelRatioF();
  const auto is_hole = [this](int loop) {
    const Document& document = impl_->document;
    return impl_->shows(loop) && (document.patch_of(loop) || document.loop(loop).kind == LoopKind::hole);
  };
  const int loop = impl_->picker.around((at.x() + 0.5) * ratio, (at.y() + 0.5) * ratio, is_hole,
                                        [this](int x, int y) { return impl_->depth_at(x, y); });
  return loop < 0 ? no_loop : loop;
}

void MeshView::hover(const QPoint& at) {
  const int loop = loop_at(at);
  impl_->selection.hover(loop);
  impl_->canvas->setCursor(loop == no_loop ? Qt::ArrowCursor : Qt::PointingHandCursor);
}

void MeshView::click(const QPoint& at, Qt::KeyboardModifiers modifiers) {
  const int loop = loop_at(at);
  const bool add = modifiers.testFlag(Qt::ControlModifier) || modifiers.testFlag(Qt::ShiftModifier);
  if (loop == no_loop) {
    if (!add) probe_at(at);
  } else if (add) {
    impl_->selection.toggle(loop);
  } else {
    impl_->selection.select({loop});
  }
}

/// On a surface: its values there. Beside everything: the selection goes.
void MeshView::probe_at(const QPoint& at) {
  if (!impl_->document.has_scan()) return;
  const std::optional<SurfacePlace> place = place_at(at);
  drop_probe();
  if (!place) {
    impl_->selection.select({});
    return;
  }
  impl_->probe = probe(impl_->document, *place);
  update_probe();
  Q_EMIT probed(impl_->probe->lines.join(QStringLiteral(" \u00b7 ")));
}

std::optional<SurfacePlace> MeshView::place_at(const QPoint& at) {
  if (!impl_->document.has_scan()) return std::nullopt;
  const std::optional<Vec3> surface = space().surface_at(at);
  return surface ? place_near(impl_->document, impl_->visibility, *surface) : std::nullopt;
}

std::optional<PieceId> MeshView::piece_under_mouse() {
  if (!impl_->mouse_at) return std::nullopt;
  const std::optional<SurfacePlace> place = place_at(*impl_->mouse_at);
  return place ? std::optional(piece_at(impl_->document, impl_->visibility, *place)) : std::nullopt;
}

void MeshView::drop_probe() {
  impl_->probe.reset();
  impl_->overlay->clear_probe();
}

void MeshView::update_probe() {
  if (!impl_->probe) return;
  const Vec3& p = impl_->probe->at;
  const Eigen::Vector4d clip = impl_->to_clip() * Eigen::Vector4d(p.x(), p.y(), p.z(), 1);
  if (clip.w() <= 0) return;
  const Eigen::Vector2d n = clip.head<2>() / clip.w();
  impl_->overlay->set_probe({(n.x() + 1) / 2 * impl_->canvas->width(), (1 - n.y()) / 2 * impl_->canvas->height()},
                            impl_->probe->lines);
}

/// Sideways, by a part of what is seen. @returns whether it is one of the arrow keys.
bool MeshView::slide_by_key(int key) {
  constexpr double part = 0.08;
  const auto [right, up] = key == Qt::Key_Left    ? std::pair{-part, 0.0}
                           : key == Qt::Key_Right ? std::pair{part, 0.0}
                           : key == Qt::Key_Up    ? std::pair{0.0, part}
                           : key == Qt::Key_Down  ? std::pair{0.0, -part}
                                                  : std::pair{0.0, 0.0};
  if (right == 0 && up == 0) return false;
  impl_->flight->stop();
  CameraPose pose = pose_of(impl_->camera());
  const Vec3 look = pose.focus - pose.position;
  // What moves to the right is the surface: the eye goes to the left.
  const Vec3 way = -look.norm() * (right * look.cross(pose.up).normalized() + up * pose.up.normalized());
  pose.focus += way;
  pose.position += way;
  apply(pose, impl_->camera());
  redraw();
  return true;
}

void MeshView::probe_middle() { probe_at(impl_->canvas->rect().center()); }

void MeshView::move_by_key(int key, Qt::KeyboardModifiers modifiers) {
  constexpr double degrees = 10, closer = 1.15;
  vtkCamera* camera = impl_->camera();
  if (modifiers.testFlag(Qt::ShiftModifier) && slide_by_key(key)) return;
  switch (key) {
    case Qt::Key_Left: camera->Azimuth(degrees); break;
    case Qt::Key_Right: camera->Azimuth(-degrees); break;
    case Qt::Key_Up: camera->Elevation(-degrees); break;
    case Qt::Key_Down: camera->Elevation(degrees); break;
    case Qt::Key_Plus:
    case Qt::Key_Equal: camera->Dolly(closer); break;
    case Qt::Key_Minus: camera->Dolly(1 / closer); break;
    default: return;
  }
  impl_->flight->stop();
  camera->OrthogonalizeViewUp();
  redraw();
}

void MeshView::set_clipping(const Clipping& clipping) {
  using Across = Clipping::Across;
  const bool only_moved = clipping.across == impl_->clipping.across &&
                          (clipping.place != impl_->clipping.place || clipping.drawn != impl_->clipping.drawn);
  if (clipping.across == Across::line_of_sight && !only_moved) {
    const CameraPose pose = pose_of(impl_->camera());
    impl_->line_of_sight = (pose.focus - pose.position).normalized();
  }
  impl_->clipping = clipping;
  const auto b = impl_->scene.bounds();
  std::optional<ClippingPlane> plane;
  if (clipping.across != Across::nothing && b[0] <= b[1]) {
    // Along an axis, the plane comes in from its positive end: what faces an eye there goes first.
    const Vec3 way = clipping.across == Across::x   ? -Vec3::UnitX()
                     : clipping.across == Across::y ? -Vec3::UnitY()
                     : clipping.across == Across::z ? -Vec3::UnitZ()
                                                    : impl_->line_of_sight;
    const Vec3 middle = 0.5 * Vec3(b[0] + b[1], b[2] + b[3], b[4] + b[5]);
    const Vec3 half = 0.5 * Vec3(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
    const double reach = half.dot(way.cwiseAbs());
    plane = ClippingPlane{middle + (2 * clipping.place - 1) * reach * way,
                          clipping.drawn == Clipping::Side::behind ? way : Vec3(-way)};
  }
  impl_->scene.set_clipping(plane);
  redraw();
}

void MeshView::set_projection(Projection projection) {
  impl_->camera()->SetParallelProjection(projection == Projection::orthographic);
  redraw();
}

void MeshView::frame() {
  impl_->flight->stop();
  const auto b = impl_->scene.bounds();
  if (!(b[0] <= b[1])) {
    redraw();
    return;
  }
  const CameraPose now = pose_of(impl_->camera());
  Stand stand;
  stand.focus = 0.5 * Vec3(b[0] + b[1], b[2] + b[3], b[4] + b[5]);
  stand.radius = 0.42 * Vec3(b[1] - b[0], b[3] - b[2], b[5] - b[4]).norm();
  stand.direction = (now.position - now.focus).normalized();
  stand.up = now.up;
  stand.aspect = impl_->aspect();
  place_camera(impl_->camera(), stand);
  match_parallel_scale(impl_->camera());
  const QSize size = impl_->pixels();
  TakenPicture picture{{size.width(), size.height()}, impl_->scene.legend_boxes()};
  const double margin = 8 * devicePixelRatioF();
  for (Eigen::AlignedBox2d& box : picture.taken) {
    box.min().array() -= margin;
    box.max().array() += margin;
  }
  clear_of(impl_->camera(), impl_->scene.sample_points(), picture);
  impl_->framed = pose_of(impl_->camera());
  redraw();
}

void MeshView::frame_if_untouched() {
  const CameraPose now = pose_of(impl_->camera());
  if (now.position == impl_->framed.position && now.focus == impl_->framed.focus) frame();
}

Viewpoint MeshView::viewpoint_above(int loop) const {
  const Document& document = impl_->document;
  const OpenedScan& scan = *document.scan(document.scan_of(loop));
  const BoundaryLoop& target = document.loop(loop);
  Stand stand;
  stand.focus = target.center - document.origin();
  stand.radius = 0.5 * loop_share * target.diameter;
  stand.direction = facing(*scan.model, target);
  stand.up = view_up(stand.direction, up());  // the camera's own would roll further with each flight
  stand.aspect = impl_->aspect();
  vtkNew<vtkCamera> goal;
  goal->DeepCopy(impl_->camera());
  place_camera(goal, stand);
  goal->OrthogonalizeViewUp();
  const CameraPose pose = pose_of(goal);
  return {pose.focus + document.origin(), pose.position + document.origin(), pose.up};
}

void MeshView::fly_to(int loop) {
  const Document& document = impl_->document;
  if (loop < 0 || loop >= document.loop_count() || !document.present(loop)) return;
  if (impl_->visibility.is_hidden_loop(loop))
    impl_->visibility.set_pieces({impl_->visibility.piece_of_loop(loop)}, SceneVisibility::Visible::shown);
  const Viewpoint goal = viewpoint_above(loop);
  impl_->flight->start(impl_->camera(), {goal.focus - document.origin(), goal.eye - document.origin(), goal.up},
                       [this] { redraw(); });
}

void MeshView::fly_to_unseen(const std::set<int>& loops) {
  constexpr double least_cosine = 0.3;  // between the line of sight and the direction in which the hole opens
  const Document& document = impl_->document;
  const Vec3 eye = pose_of(impl_->camera()).position;
  int widest = no_loop;
  for (int loop : loops) {
    if (loop >= document.loop_count() || !document.present(loop)) continue;
    const BoundaryLoop& target = document.loop(loop);
    const Vec3 to_eye = (eye - (target.center - document.origin())).normalized();
    const bool faces = facing(*document.scan(document.scan_of(loop))->model, target).dot(to_eye) > least_cosine;
    const bool inside = rect().contains(position_of(loop, 0)) && rect().contains(position_of(loop, target.edges() / 2));
    if (faces && inside && !impl_->visibility.is_hidden_loop(loop)) return;
    if (widest == no_loop || target.diameter > document.loop(widest).diameter) widest = loop;
  }
  fly_to(widest);
}

QImage MeshView::picture() const { return impl_->canvas->grabFramebuffer(); }

bool MeshView::is_flying() const { return impl_->flight->is_flying(); }

bool MeshView::is_rough() const { return impl_->scene.is_rough(); }

QImage MeshView::picture(const PictureOptions& options) {
  using Extras = PictureOptions::Extras;
  const bool see_through = options.ground == PictureOptions::Ground::transparent;
  vtkRenderer* renderer = impl_->renderer();
  vtkGenericOpenGLRenderWindow* window = impl_->window;
  // Letters and lines as large, against the picture, as they are in the window.
  const double ratio = static_cast<double>(options.size.height()) / std::max(1, impl_->canvas->height());
  impl_->canvas->makeCurrent();
  const QSize old = impl_->pixels();
  const bool before = std::exchange(impl_->drawing_elsewhere, true);
  window->SetSize(options.size.width(), options.size.height());
  impl_->scene.set_pixel_ratio(ratio);
  impl_->scene.set_size(options.size.width(), options.size.height());
  impl_->scene.set_covered(0);
  impl_->scene.set_legend(options.extras == Extras::none ? LegendPlace::none : LegendPlace::over_the_picture);
  if (see_through) {
    impl_->scene.set_ground(MeshScene::Ground::transparent);
    window->SetAlphaBitPlanes(1);
  }
  if (options.outlined >= 0) {
    impl_->scene.set_loops({{line_of_loop(options.outlined), LoopStyle::filled}});
    impl_->scene.set_seams(Seams::shown);
  }
  impl_->scene.set_large_scans(MeshScene::LargeScans::whole);
  impl_->scene.arrive();
  renderer->ResetCameraClippingRange();
  window->Render();
  impl_->scene.set_large_scans(MeshScene::LargeScans::reduced_at_first);
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetRGBACharPixelData(0, 0, options.size.width() - 1, options.size.height() - 1, 0, pixels);
  const bool complete =
      pixels->GetNumberOfTuples() == static_cast<vtkIdType>(options.size.width()) * options.size.height();
  QImage picture;
  if (complete)
    picture = QImage(pixels->GetPointer(0), options.size.width(), options.size.height(), QImage::Format_RGBA8888)
                  .mirrored()
                  .convertToFormat(see_through ? QImage::Format_ARGB32 : QImage::Format_RGB32);
  if (options.outlined >= 0) {
    impl_->scene.set_seams(impl_->look.seams);
    impl_->loop_styles.clear();
    update_loops();
  }
  impl_->scene.set_ground(MeshScene::Ground::shown);
  window->SetSize(old.width(), old.height());
  impl_->scene.set_pixel_ratio(devicePixelRatioF());
  impl_->scene.set_size(old.width(), old.height());
  set_covered(impl_->covered);
  impl_->scene.set_legend(LegendPlace::over_the_picture);
  impl_->drawing_elsewhere = before;
  redraw();
  if (complete && options.extras == Extras::legend_axes_scale) {
    QPainter painter(&picture);
    painter.scale(ratio, ratio);
    impl_->overlay->paint_frame(painter);
  }
  return picture;
}

void MeshView::set_covered(int height) {
  impl_->covered = height;
  impl_->scene.set_covered(static_cast<int>(height * devicePixelRatioF()));
  redraw();
}

QPoint MeshView::position_of(int loop, int vertex) const {
  impl_->follow_camera();
  const LoopPicker::Pixel& p = impl_->picker.projected(loop)[vertex];
  return (QPointF(p.x(), p.y()) / impl_->canvas->devicePixelRatioF()).toPoint();
}

void MeshView::after_render() {
  if (impl_->drawing_elsewhere) return;
  Q_EMIT drawn();
  impl_->depth_is_fresh = false;
  update_tool();
  const bool moved = impl_->camera()->GetMTime() != impl_->seen_camera;
  impl_->follow_camera();
  if (moved) impl_->last_move.start();
  if (impl_->scene.is_rough()) redraw_at_rest();
  if (!moved) return;
  update_highlight();
  update_marks();
  update_probe();
}

void MeshView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  impl_->overlay->setGeometry(rect());
  impl_->overlay->raise();
  impl_->sheet->setGeometry(rect());
  impl_->sheet->raise();
  update_hidden_note();
  const QSize size = this->size() * devicePixelRatioF();
  impl_->scene.set_pixel_ratio(devicePixelRatioF());
  impl_->scene.set_size(size.width(), size.height());
  impl_->seen_camera = 0;  // what lies over the picture moves with it
  redraw();  // the canvas was drawn at its new size before the legend knew of it
  if (impl_->document.has_scan()) frame_if_untouched();
}

void MeshView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) update_palette();
}

void MeshView::update_palette() {
  const bool dark = palette().color(QPalette::Window).lightness() < 128;
  impl_->scene.set_background(dark ? MeshScene::Background::dark : MeshScene::Background::light);
  redraw();
}

}  // namespace loopmend
