// SPDX-License-Identifier: GPL-3.0-or-later
// In place of the scene's pictures, for a build without VTK (LOOPMEND_PICTURES).
#include "core/error.h"
#include "scene/film.h"
#include "scene/offscreen_render.h"

namespace loopmend {

namespace {

[[noreturn]] void refuse() { throw Error(say("this program was built without VTK and draws no pictures.")); }

}  // namespace

std::string render_surface(const SurfaceModel&, const RenderOptions&) { refuse(); }

std::string render_before_after(const SurfaceModel&, const SurfaceModel&, const RenderOptions&) { refuse(); }

std::string render_panels(const std::vector<Panel>&, int, const RenderOptions&) { refuse(); }

std::size_t render_film(std::ostream&, const SurfaceModel&, const std::vector<FilmState>&, const RenderOptions&) {
  refuse();
}

}  // namespace loopmend
