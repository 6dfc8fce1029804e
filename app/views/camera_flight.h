// SPDX-License-Identifier: GPL-3.0-or-later
// Moves a camera smoothly from where it is to where it should be.
#pragma once

#include <Eigen/Core>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <functional>

class vtkCamera;

namespace loopmend {

struct CameraPose {
  Eigen::Vector3d focus = Eigen::Vector3d::Zero();
  Eigen::Vector3d position = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();
};

CameraPose pose_of(vtkCamera* camera);
void apply(const CameraPose& pose, vtkCamera* camera);

class CameraFlight : public QObject {
  Q_OBJECT

 public:
  explicit CameraFlight(QObject* parent);
  void start(vtkCamera* camera, const CameraPose& goal, std::function<void()> redraw);
  void stop();
  bool is_flying() const { return timer_.isActive(); }

 private:
  void advance();

  QTimer timer_{this};
  QElapsedTimer clock_;
  vtkCamera* camera_ = nullptr;
  CameraPose from_, to_;
  std::function<void()> redraw_;
};

}  // namespace loopmend
