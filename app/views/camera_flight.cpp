// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/camera_flight.h"

#include <vtkCamera.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

constexpr int duration_ms = 350;

/// Along the arc around the focus, so that the eye never dives through the surface.
Eigen::Vector3d turn(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double t) {
  const Eigen::Vector3d across = a.cross(b);
  const bool opposite = across.norm() < 1e-12 * a.norm() * b.norm();
  const Eigen::Vector3d axis = opposite ? a.unitOrthogonal() : across.normalized();
  const double angle = std::atan2(across.norm(), a.dot(b));
  const double length = (1 - t) * a.norm() + t * b.norm();
  return (Eigen::AngleAxisd(t * angle, axis) * a).normalized() * length;
}

}  // namespace

CameraPose pose_of(vtkCamera* camera) {
  CameraPose pose;
  camera->GetFocalPoint(pose.focus.data());
  camera->GetPosition(pose.position.data());
  camera->GetViewUp(pose.up.data());
  return pose;
}

void apply(const CameraPose& pose, vtkCamera* camera) {
  camera->SetFocalPoint(pose.focus.data());
  camera->SetPosition(pose.position.data());
  camera->SetViewUp(pose.up.data());
  camera->OrthogonalizeViewUp();
}

CameraFlight::CameraFlight(QObject* parent) : QObject(parent) {
  timer_.setInterval(15);
  connect(&timer_, &QTimer::timeout, this, &CameraFlight::advance);
}

void CameraFlight::start(vtkCamera* camera, const CameraPose& goal, std::function<void()> redraw) {
  camera_ = camera;
  from_ = pose_of(camera);
  to_ = goal;
  redraw_ = std::move(redraw);
  clock_.start();
  timer_.start();
}

void CameraFlight::stop() { timer_.stop(); }

void CameraFlight::advance() {
  const double t = std::min(1.0, static_cast<double>(clock_.elapsed()) / duration_ms);
  const double eased = t * t * (3 - 2 * t);
  CameraPose pose;
  pose.focus = (1 - eased) * from_.focus + eased * to_.focus;
  pose.position = pose.focus + turn(from_.position - from_.focus, to_.position - to_.focus, eased);
  pose.up = turn(from_.up, to_.up, eased).normalized();
  apply(pose, camera_);
  if (t >= 1) timer_.stop();
  redraw_();
}

}  // namespace loopmend
