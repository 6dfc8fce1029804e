// SPDX-License-Identifier: GPL-3.0-or-later
// A VTK render window that needs no display: an EGL context without a surface in offscreen_window_posix.cpp, a window that is not shown in
// offscreen_window_windows.cpp.
#pragma once

#include <vtkSmartPointer.h>

class vtkRenderWindow;

namespace loopmend {

/// @throws Error in words when this machine offers no such context.
vtkSmartPointer<vtkRenderWindow> make_offscreen_window(int width, int height);

}  // namespace loopmend
