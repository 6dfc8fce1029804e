// SPDX-License-Identifier: GPL-3.0-or-later
// The module that draws: all that needs VTK, X and a graphics driver.
#include "picture_functions.h"

extern "C" [[gnu::visibility("default")]] const loopmend::PictureFunctions* loopmend_picture_functions() {
  static const loopmend::PictureFunctions functions{loopmend::render_surface, loopmend::render_before_after,
                                                    loopmend::render_panels, loopmend::render_film};
  return &functions;
}
