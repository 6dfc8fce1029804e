// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view_direction.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

constexpr double pi = 3.14159265358979323846;

/// What the front shows.
Vec3 ahead_of(const Vec3& up) { return std::abs(up.z()) > 0.5 ? Vec3(0, -1, 0) : Vec3(0, 0, 1); }

Vec3 boundary_normal(const SurfaceModel& model, const BoundaryLoop& loop) {
  Vec3 sum = Vec3::Zero();
  for (int v : loop.vertices)
    for (auto face : model.mesh.vf_range(model.mesh.vertex_handle(static_cast<unsigned>(v)))) {
      auto it = model.mesh.cfv_iter(face);
      const Vec3 a = model.mesh.point(*it++), b = model.mesh.point(*it++), c = model.mesh.point(*it);
      sum += (b - a).cross(c - a);
    }
  return sum;
}

/// Newell's normal of the loop itself; the hole lies to the left of the boundary halfedges.
Vec3 loop_normal(const SurfaceModel& model, const BoundaryLoop& loop) {
  Vec3 sum = Vec3::Zero();
  const std::size_t n = loop.vertices.size();
  const auto at = [&](std::size_t i) -> Vec3 {
    return model.mesh.point(model.mesh.vertex_handle(static_cast<unsigned>(loop.vertices[i % n])));
  };
  for (std::size_t i = 0; i < n; ++i) sum += (at(i) - loop.center).cross(at(i + 1) - loop.center);
  return sum;
}

/// What the points cover of the picture, −1..1 both ways.
Eigen::AlignedBox2d seen_box(vtkCamera* camera, const std::vector<float>& points, double aspect) {
  const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> to_clip(
      camera->GetCompositeProjectionTransformMatrix(aspect, -1, 1)->GetData());
  Eigen::AlignedBox2d box;
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    const Eigen::Vector4d p = to_clip * Eigen::Vector4d(points[i], points[i + 1], points[i + 2], 1);
    if (p.w() > 0) box.extend(p.head<2>() / p.w());
  }
  return box;
}

bool is_clear(vtkCamera* camera, const std::vector<float>& points, const TakenPicture& picture) {
  const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> to_clip(
      camera->GetCompositeProjectionTransformMatrix(picture.size.x() / picture.size.y(), -1, 1)->GetData());
  const Eigen::AlignedBox2d whole(Eigen::Vector2d::Zero(), picture.size);
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    const Eigen::Vector4d p = to_clip * Eigen::Vector4d(points[i], points[i + 1], points[i + 2], 1);
    const Eigen::Vector2d at = 0.5 * picture.size.cwiseProduct(p.head<2>() / p.w() + Eigen::Vector2d::Ones());
    if (!(p.w() > 0) || !whole.contains(at)) return false;
    for (const Eigen::AlignedBox2d& box : picture.taken)
      if (box.contains(at)) return false;
  }
  return true;
}

/// Moves eye and focus in the picture's plane, so that `middle` comes to its centre.
void shift(vtkCamera* camera, const Eigen::Vector2d& middle, double aspect) {
  Vec3 eye, focus, up;
  camera->GetPosition(eye.data());
  camera->GetFocalPoint(focus.data());
  camera->GetViewUp(up.data());
  const Vec3 ahead = (focus - eye).normalized(), right = ahead.cross(up).normalized();
  const double half_height = (focus - eye).norm() * std::tan(0.5 * camera->GetViewAngle() * pi / 180);
  const Vec3 move = half_height * (middle.x() * aspect * right + middle.y() * right.cross(ahead));
  eye += move;
  focus += move;
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(focus.data());
}

}  // namespace

Vec3 facing(const SurfaceModel& model, const BoundaryLoop& loop) {
  const Vec3 around = boundary_normal(model, loop).normalized(), across = loop_normal(model, loop).normalized();
  // The outline of a sheet runs the other way round than the boundary of a hole: there only the surface shows where outside is.
  const bool is_outline = loop.kind == LoopKind::outer_rim && across.dot(around) < -0.3;
  const Vec3 both = is_outline ? around : Vec3(across + 0.5 * around);
  return both.norm() > 1e-6 && both.allFinite() ? Vec3(both.normalized()) : Vec3(Vec3::UnitZ());
}

Vec3 view_direction(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, const Vec3& wanted_up) {
  Vec3 sum = Vec3::Zero(), largest = Vec3::Zero();
  double largest_perimeter = 0;
  for (const BoundaryLoop& loop : loops) {
    if (loop.kind != LoopKind::hole) continue;
    const Vec3 d = facing(model, loop);
    sum += loop.perimeter * d;
    if (loop.perimeter > largest_perimeter) {
      largest_perimeter = loop.perimeter;
      largest = d;
    }
  }
  if (largest_perimeter <= 0) return front(wanted_up);
  const Vec3 main = sum.norm() > 0.4 * largest_perimeter ? Vec3(sum.normalized()) : largest;
  const Vec3 up = view_up(main, wanted_up);
  const Vec3 side = up.cross(main).normalized();
  return (main + 0.28 * up - 0.22 * side).normalized();
}

Vec3 guessed_up(const Vec3& extents) {
  constexpr double clearly = 1.1;
  return extents.z() > clearly * extents.head<2>().maxCoeff() ? Vec3::UnitZ() : Vec3::UnitY();
}

Vec3 up_of(UpAxis axis, const Vec3& extents) {
  switch (axis) {
    case UpAxis::x: return Vec3::UnitX();
    case UpAxis::minus_x: return -Vec3::UnitX();
    case UpAxis::y: return Vec3::UnitY();
    case UpAxis::minus_y: return -Vec3::UnitY();
    case UpAxis::z: return Vec3::UnitZ();
    case UpAxis::minus_z: return -Vec3::UnitZ();
    case UpAxis::by_shape: break;
  }
  return guessed_up(extents);
}

Vec3 view_up(const Vec3& direction, const Vec3& wanted) {
  if (std::abs(direction.dot(wanted)) < 0.9) return wanted;
  return direction.dot(wanted) > 0 ? Vec3(-ahead_of(wanted)) : ahead_of(wanted);
}

Vec3 front(const Vec3& up) {
  const Vec3 ahead = ahead_of(up), right = up.cross(ahead);
  return (ahead + 0.2 * up + (std::abs(up.z()) > 0.5 ? 0.3 : 0.2) * right).normalized();
}

Vec3 direction_of(NamedView view, const Vec3& up) {
  const Vec3 ahead = ahead_of(up), right = up.cross(ahead);
  switch (view) {
    case NamedView::front: return ahead;
    case NamedView::back: return -ahead;
    case NamedView::left: return -right;
    case NamedView::right: return right;
    case NamedView::top: return up;
    case NamedView::bottom: return -up;
    case NamedView::iso: return (ahead + right + up).normalized();
  }
  return ahead;
}

void place_camera(vtkCamera* camera, const Stand& stand) {
  const double half = 0.5 * camera->GetViewAngle() * pi / 180;
  const double narrowest = std::atan(std::tan(half) * std::min(1.0, stand.aspect));
  const double distance = stand.radius / std::sin(narrowest);
  const Vec3 eye = stand.focus + distance * stand.direction;
  camera->SetFocalPoint(stand.focus.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(stand.up.data());
}

void fit(vtkCamera* camera, const std::vector<float>& points, double aspect, double share) {
  constexpr int rounds = 2;  // moving sideways changes the perspective a little
  for (int round = 0; round < rounds; ++round) {
    const Eigen::AlignedBox2d seen = seen_box(camera, points, aspect);
    if (seen.isEmpty()) return;
    shift(camera, seen.center(), aspect);
    const double widest = (0.5 * seen.sizes()).maxCoeff();
    if (widest > 0) camera->Zoom(std::clamp(share / widest, 0.2, 3.0));
  }
}

void clear_of(vtkCamera* camera, const std::vector<float>& points, const TakenPicture& picture) {
  constexpr double step = 1.02, most = 3;
  for (double away = 1; away < most && !is_clear(camera, points, picture); away *= step) {
    Vec3 eye, focus;
    camera->GetPosition(eye.data());
    camera->GetFocalPoint(focus.data());
    eye = focus + step * (eye - focus);
    camera->SetPosition(eye.data());
    camera->SetParallelScale(step * camera->GetParallelScale());
  }
}

}  // namespace loopmend
