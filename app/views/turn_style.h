// SPDX-License-Identifier: GPL-3.0-or-later
// How the mouse turns and zooms a picture; nothing else.
#pragma once

#include <vtkSmartPointer.h>

class vtkCamera;
class vtkInteractorStyle;

namespace loopmend {

/// Without perspective as much is seen at the focus as with it.
void match_parallel_scale(vtkCamera* camera);

/// Moves closer by this factor, so that what lies in the focal plane at this point of the picture stays there.
/// @param x, y  -1..1, to the right and upward; @param aspect  width / height of the picture
void zoom_to(vtkCamera* camera, double factor, double x, double y, double aspect);

/// VTK's trackball without VTK's own keys (q quits!); the wheel zooms to the cursor.
vtkSmartPointer<vtkInteractorStyle> make_turn_style();

}  // namespace loopmend
