// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/offscreen_window.h"

#include "core/error.h"

#include <vtkRenderWindow.h>

namespace loopmend {

vtkSmartPointer<vtkRenderWindow> make_offscreen_window(int width, int height) {
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetShowWindow(false);
  window->SetUseOffScreenBuffers(true);
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  if (!window->SupportsOpenGL())
    throw Error(say("cannot draw: this machine has no OpenGL 3.2. Install the driver of the graphics card."));
  return window;
}

}  // namespace loopmend
