// SPDX-License-Identifier: GPL-3.0-or-later
// How the mouse turns, moves and zooms a picture, by the table in document/navigation.h; nothing else.
#pragma once

#include "document/navigation.h"

#include <vtkSmartPointer.h>

#include <Eigen/Core>

#include <functional>
#include <memory>

class vtkCamera;
class vtkInteractorStyle;

namespace loopmend {

/// Without perspective as much is seen at the focus as with it.
void match_parallel_scale(vtkCamera* camera);

/// Moves closer by this factor, so that what lies in the focal plane at this point of the picture stays there.
/// @param x, y  -1..1, to the right and upward; @param aspect  width / height of the picture
void zoom_to(vtkCamera* camera, double factor, double x, double y, double aspect);

/// Turns the eye round the focus: about the up axis, and towards it, at most until it looks along it. The axis stays upright in the
/// picture. @param around, towards  degrees
void turn_about(vtkCamera* camera, const Eigen::Vector3d& up, double around, double towards);

/// Read when a drag begins.
struct TurnRules {
  NavigationStyle style = NavigationStyle::loopmend;
  Hand hand = Hand::empty;
  std::function<Eigen::Vector3d()> up;  ///< empty: what is up in the picture
};

/// VTK's trackball without VTK's own buttons and keys (q quits!); the wheel zooms to the cursor.
vtkSmartPointer<vtkInteractorStyle> make_turn_style(std::shared_ptr<const TurnRules> rules);

}  // namespace loopmend
