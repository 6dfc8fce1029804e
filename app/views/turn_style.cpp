// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/turn_style.h"

#include <vtkCamera.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

/// Half of what is seen of the plane through the focus, from top to bottom.
double half_height(vtkCamera* camera) {
  constexpr double half_degree = 3.14159265358979323846 / 360;
  return camera->GetDistance() * std::tan(camera->GetViewAngle() * half_degree);
}

class TurnStyle : public vtkInteractorStyleTrackballCamera {
 public:
  static TurnStyle* New();
  vtkTypeMacro(TurnStyle, vtkInteractorStyleTrackballCamera) void OnChar() override {}
  void OnKeyPress() override {}
  void OnKeyDown() override {}
  void OnMouseWheelForward() override {
    towards_ = Towards::cursor;
    Superclass::OnMouseWheelForward();
    towards_ = Towards::middle;
  }
  void OnMouseWheelBackward() override {
    towards_ = Towards::cursor;
    Superclass::OnMouseWheelBackward();
    towards_ = Towards::middle;
  }

 protected:
  void Dolly(double factor) override {
    if (!CurrentRenderer || !(factor > 0)) return;
    vtkCamera* camera = CurrentRenderer->GetActiveCamera();
    if (towards_ == Towards::cursor) {
      const int* at = Interactor->GetEventPosition();
      const int *size = CurrentRenderer->GetSize(), *corner = CurrentRenderer->GetOrigin();
      zoom_to(camera, factor, 2.0 * (at[0] - corner[0]) / std::max(1, size[0]) - 1,
              2.0 * (at[1] - corner[1]) / std::max(1, size[1]) - 1,
              static_cast<double>(size[0]) / std::max(1, size[1]));
    } else {
      camera->Dolly(factor);
    }
    match_parallel_scale(camera);
    CurrentRenderer->ResetCameraClippingRange();
    if (Interactor->GetLightFollowCamera()) CurrentRenderer->UpdateLightsGeometryToFollowCamera();
    Interactor->Render();
  }

 private:
  enum class Towards { middle, cursor } towards_ = Towards::middle;
};
vtkStandardNewMacro(TurnStyle)

}  // namespace

void match_parallel_scale(vtkCamera* camera) { camera->SetParallelScale(half_height(camera)); }

void zoom_to(vtkCamera* camera, double factor, double x, double y, double aspect) {
  const Eigen::Vector3d focus(camera->GetFocalPoint()), eye(camera->GetPosition());
  Eigen::Vector3d up(camera->GetViewUp());
  const Eigen::Vector3d right = (focus - eye).cross(up).normalized();
  up = right.cross(focus - eye).normalized();
  const Eigen::Vector3d way = (1 - 1 / factor) * half_height(camera) * (x * aspect * right + y * up);
  camera->Dolly(factor);
  const Eigen::Vector3d new_focus = focus + way, new_eye = Eigen::Vector3d(camera->GetPosition()) + way;
  camera->SetFocalPoint(new_focus.data());
  camera->SetPosition(new_eye.data());
}

vtkSmartPointer<vtkInteractorStyle> make_turn_style() { return vtkSmartPointer<TurnStyle>::New(); }

}  // namespace loopmend
