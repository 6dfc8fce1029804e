#include "views/mesh_view_impl.h"

#include "scene/view_direction.h"

#include <QMouseEvent>

namespace loopmend {
namespace {

constexpr double pick_reach = 9;    ///< logical pixels
constexpr int click_slack = 4;      ///< a press that moves less is a click
constexpr double loop_share = 2.4;  ///< how many loop diameters are seen around a loop flown to

}  // namespace

bool MeshView::eventFilter(QObject* watched, QEvent* event) {
  if (watched != impl_->canvas) return QWidget::eventFilter(watched, event);
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
      break;
    }
    case QEvent::MouseButtonDblClick: {
      const int loop = loop_at(static_cast<QMouseEvent*>(event)->pos());
      if (loop != no_loop) fly_to(loop);
      break;
    }
    case QEvent::Leave: impl_->selection.hover(no_loop); break;
    case QEvent::Wheel: impl_->flight->stop(); break;
    default: break;
  }
  return QWidget::eventFilter(watched, event);
}

int MeshView::loop_at(const QPoint& at) {
  if (!impl_->document.has_scan() || impl_->picker.count() == 0) return no_loop;
  impl_->follow_camera();
  const double ratio = impl_->canvas->devicePixelRatioF();
  const int loop = impl_->picker.pick((at.x() + 0.5) * ratio, (at.y() + 0.5) * ratio, pick_reach * ratio,
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
  if (add && loop != no_loop) impl_->selection.toggle(loop);
  if (!add) impl_->selection.select(loop == no_loop ? std::set<int>{} : std::set<int>{loop});
}

void MeshView::face_front() {
  const auto b = impl_->scene.bounds();
  const Vec3 up = guessed_up(Vec3(b[1] - b[0], b[3] - b[2], b[5] - b[4]));
  CameraPose pose;
  pose.position = front(up);
  pose.up = up;
  apply(pose, impl_->camera());
  frame();
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
  redraw();
}

void MeshView::fly_to(int loop) {
  if (!impl_->document.has_scan()) return;
  const OpenedScan& scan = impl_->document.scan();
  const BoundaryLoop& target = scan.loops[static_cast<std::size_t>(loop)];
  Stand stand;
  stand.focus = target.center - scan.origin;
  stand.radius = 0.5 * loop_share * target.diameter;
  stand.direction = facing(*scan.model, target);
  const Vec3 up = pose_of(impl_->camera()).up;
  const bool usable = std::abs(up.dot(stand.direction)) < 0.9;
  stand.up = usable ? up : view_up(stand.direction, Vec3::UnitY());
  stand.aspect = impl_->aspect();
  vtkNew<vtkCamera> goal;
  goal->DeepCopy(impl_->camera());
  place_camera(goal, stand);
  goal->OrthogonalizeViewUp();
  impl_->flight->start(impl_->camera(), pose_of(goal), [this] { redraw(); });
}

QImage MeshView::picture() const { return impl_->canvas->grabFramebuffer(); }

QPoint MeshView::position_of(int loop, int vertex) const {
  impl_->follow_camera();
  const LoopPicker::Pixel& p = impl_->picker.projected(loop)[static_cast<std::size_t>(vertex)];
  return (QPointF(p.x(), p.y()) / impl_->canvas->devicePixelRatioF()).toPoint();
}

void MeshView::after_render() {
  impl_->depth_is_fresh = false;
  const bool moved = impl_->camera()->GetMTime() != impl_->seen_camera;
  impl_->follow_camera();
  if (moved) update_highlight();
}

void MeshView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  impl_->overlay->setGeometry(rect());
  impl_->overlay->raise();
  const QSize size = this->size() * devicePixelRatioF();
  impl_->scene.set_pixel_ratio(devicePixelRatioF());
  impl_->scene.set_size(size.width(), size.height());
  redraw();  // the canvas was drawn at its new size before the legend knew of it
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
