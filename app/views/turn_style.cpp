// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/turn_style.h"

#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkObjectFactory.h>

namespace loopmend {
namespace {

class TurnStyle : public vtkInteractorStyleTrackballCamera {
 public:
  static TurnStyle* New();
  vtkTypeMacro(TurnStyle, vtkInteractorStyleTrackballCamera) void OnChar() override {}
  void OnKeyPress() override {}
  void OnKeyDown() override {}
};
vtkStandardNewMacro(TurnStyle)

}  // namespace

vtkSmartPointer<vtkInteractorStyle> make_turn_style() { return vtkSmartPointer<TurnStyle>::New(); }

}  // namespace loopmend
