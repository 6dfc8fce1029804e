// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line takes from the module that draws pictures (load_pictures.cpp, pictures_module.cpp). Both are of one build.
#pragma once

#include "scene/film.h"
#include "scene/offscreen_render.h"

namespace loopmend {

struct PictureFunctions {
  decltype(&render_surface) surface;
  decltype(&render_before_after) before_after;
  decltype(&render_panels) panels;
  decltype(&render_film) film;
};

/// The function that the module exports, with C linkage.
inline constexpr const char* picture_functions_name = "loopmend_picture_functions";

}  // namespace loopmend
