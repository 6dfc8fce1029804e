// SPDX-License-Identifier: GPL-3.0-or-later
// How the mouse turns and zooms a picture; nothing else.
#pragma once

#include <vtkSmartPointer.h>

class vtkInteractorStyle;

namespace loopmend {

/// VTK's trackball without VTK's own keys (q quits!).
vtkSmartPointer<vtkInteractorStyle> make_turn_style();

}  // namespace loopmend
