// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/turn_style.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
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
  void follow(std::shared_ptr<const TurnRules> rules) { rules_ = std::move(rules); }
  void OnKeyPress() override {}
  void OnKeyDown() override {}
  void OnLeftButtonDown() override { begin(Qt::LeftButton); }
  void OnLeftButtonUp() override { end(Qt::LeftButton); }
  void OnMiddleButtonDown() override { begin(Qt::MiddleButton); }
  void OnMiddleButtonUp() override { end(Qt::MiddleButton); }
  void OnRightButtonDown() override { begin(Qt::RightButton); }
  void OnRightButtonUp() override { end(Qt::RightButton); }
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
  void Rotate() override {
    if (!CurrentRenderer) return;
    if (navigation(rules_->style).turning == Turning::freely) {
      Superclass::Rotate();
      return;
    }
    const int *now = Interactor->GetEventPosition(), *before = Interactor->GetLastEventPosition();
    const int* size = CurrentRenderer->GetRenderWindow()->GetSize();
    constexpr double across = 200;  // degrees, from one side of the picture to the other; as VTK's trackball
    turn_about(CurrentRenderer->GetActiveCamera(), up_, -across * (now[0] - before[0]) / std::max(1, size[0]),
               -across * (now[1] - before[1]) / std::max(1, size[1]));
    CurrentRenderer->ResetCameraClippingRange();
    if (Interactor->GetLightFollowCamera()) CurrentRenderer->UpdateLightsGeometryToFollowCamera();
    Interactor->Render();
  }

 private:
  void begin(Qt::MouseButton button) {
    if (State != VTKIS_NONE) return;  // one drag at a time
    const int* at = Interactor->GetEventPosition();
    FindPokedRenderer(at[0], at[1]);
    if (!CurrentRenderer) return;
    Qt::KeyboardModifiers held;
    held.setFlag(Qt::ShiftModifier, Interactor->GetShiftKey() != 0);
    held.setFlag(Qt::ControlModifier, Interactor->GetControlKey() != 0);
    held.setFlag(Qt::AltModifier, Interactor->GetAltKey() != 0);
    const Motion motion = motion_of(rules_->style, button, held, rules_->hand);
    if (motion == Motion::nothing) return;
    button_ = button;
    if (rules_->up)
      up_ = rules_->up();
    else
      CurrentRenderer->GetActiveCamera()->GetViewUp(up_.data());
    GrabFocus(EventCallbackCommand);
    switch (motion) {
      case Motion::turn: StartRotate(); break;
      case Motion::slide: StartPan(); break;
      case Motion::zoom: StartDolly(); break;
      case Motion::roll: StartSpin(); break;
      case Motion::nothing: break;
    }
  }
  void end(Qt::MouseButton button) {
    if (State == VTKIS_NONE || button != button_) return;
    switch (State) {
      case VTKIS_ROTATE: EndRotate(); break;
      case VTKIS_PAN: EndPan(); break;
      case VTKIS_DOLLY: EndDolly(); break;
      case VTKIS_SPIN: EndSpin(); break;
      default: break;
    }
    ReleaseFocus();
  }

  std::shared_ptr<const TurnRules> rules_ = std::make_shared<TurnRules>();
  Qt::MouseButton button_ = Qt::NoButton;  ///< of the drag
  Eigen::Vector3d up_ = Eigen::Vector3d::UnitY();
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

void turn_about(vtkCamera* camera, const Eigen::Vector3d& up, double around, double towards) {
  constexpr double degree = 3.14159265358979323846 / 180;
  const Eigen::Vector3d focus(camera->GetFocalPoint()), was_up(camera->GetViewUp());
  Eigen::Vector3d to_eye = Eigen::Vector3d(camera->GetPosition()) - focus;
  Eigen::Vector3d right = up.cross(to_eye);  // what was rolled is upright again
  if (right.norm() < 1e-6 * to_eye.norm()) right = was_up.cross(to_eye);
  right.normalize();
  const double side = right.dot(was_up.cross(to_eye)) < 0 ? -1 : 1;  // head down, it stays so
  right *= side;
  const double height = std::asin(std::clamp(to_eye.normalized().dot(up), -1.0, 1.0));
  const double wanted = std::clamp(height + side * towards * degree, -90 * degree, 90 * degree);
  to_eye = Eigen::AngleAxisd(-side * (wanted - height), right) * to_eye;
  const Eigen::AngleAxisd turn(around * degree, up);
  const Eigen::Vector3d eye = focus + turn * to_eye, now_up = turn * to_eye.cross(right).normalized();
  camera->SetPosition(eye.data());
  camera->SetViewUp(now_up.data());
}

vtkSmartPointer<vtkInteractorStyle> make_turn_style(std::shared_ptr<const TurnRules> rules) {
  const auto style = vtkSmartPointer<TurnStyle>::New();
  style->follow(std::move(rules));
  return style;
}

}  // namespace loopmend
