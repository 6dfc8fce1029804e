// SPDX-License-Identifier: GPL-3.0-or-later
// From which side MeshView shows the scene: the up axis, the named sides, the cube in the corner.
#include "views/mesh_view_impl.h"

#include <QMouseEvent>

namespace loopmend {

Vec3 MeshView::up() const {
  const auto b = impl_->scene.bounds();
  return up_of(impl_->look.up, Vec3(b[1] - b[0], b[3] - b[2], b[5] - b[4]));
}

void MeshView::set_navigation(NavigationStyle style) { impl_->turning->style = style; }

void MeshView::face_front() {
  CameraPose pose;
  pose.position = front(up());
  pose.up = up();
  apply(pose, impl_->camera());
  frame();
}

void MeshView::look_from(NamedView side) {
  impl_->flight->stop();
  CameraPose pose;
  pose.position = direction_of(side, up());
  pose.up = view_up(pose.position, up());
  apply(pose, impl_->camera());
  frame();
}

void MeshView::fly_to_side(NamedView side) {
  const CameraPose now = pose_of(impl_->camera());
  look_from(side);
  const CameraPose goal = pose_of(impl_->camera());
  apply(now, impl_->camera());
  impl_->flight->start(impl_->camera(), goal, [this] { redraw(); });
}

void MeshView::fly_to_place(const Vec3& center, double radius, const Vec3& direction) {
  constexpr double share = 3;  // of what is around it
  const auto b = impl_->scene.bounds();
  const double least = 0.06 * Vec3(b[1] - b[0], b[3] - b[2], b[5] - b[4]).norm();
  Stand stand;
  stand.focus = center - impl_->document.origin();
  stand.radius = std::max(share * radius, least);
  stand.direction = direction;
  stand.up = view_up(direction, up());
  stand.aspect = impl_->aspect();
  vtkNew<vtkCamera> goal;
  goal->DeepCopy(impl_->camera());
  place_camera(goal, stand);
  goal->OrthogonalizeViewUp();
  impl_->place = MarkedPlace{stand.focus, radius};
  impl_->flight->start(impl_->camera(), pose_of(goal), [this] { redraw(); });
}

/// A press on the cube is for the cube alone, and so is what follows until the release.
bool MeshView::cube_takes(QEvent* event) {
  const auto type = event->type();
  if (type == QEvent::Leave) impl_->cube->set_hovered(std::nullopt);
  const bool moves = type == QEvent::MouseMove, releases = type == QEvent::MouseButtonRelease;
  const bool presses = type == QEvent::MouseButtonPress || type == QEvent::MouseButtonDblClick;
  if (!moves && !presses && !releases) return false;
  const auto& mouse = *static_cast<QMouseEvent*>(event);
  if (impl_->pressed_side) {
    if (releases && mouse.button() == Qt::LeftButton) {
      const NamedView side = *std::exchange(impl_->pressed_side, std::nullopt);
      if (impl_->cube->side_at(mouse.pos()) == side) fly_to_side(side);
    }
    return true;
  }
  if (releases || mouse.buttons() != (presses ? Qt::MouseButtons(Qt::LeftButton) : Qt::NoButton)) return false;
  const std::optional<NamedView> side = impl_->cube->side_at(mouse.pos());
  if (moves && side != impl_->hovered_side) {
    impl_->cube->set_hovered(side);
    if (side)
      impl_->canvas->setCursor(Qt::PointingHandCursor);
    else
      impl_->canvas->unsetCursor();
    impl_->hovered_side = side;
  }
  if (!side) return false;
  if (presses) impl_->pressed_side = side;
  impl_->selection.hover(no_loop);
  return true;
}

}  // namespace loopmend
