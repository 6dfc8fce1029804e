// SPDX-License-Identifier: GPL-3.0-or-later
// In place of the scene's pictures, for the command line: the module that draws them is loaded when a picture is asked for, so that
// other commands start without VTK.
#include "core/error.h"
#include "core/own_files.h"
#include "core/path_text.h"
#include "picture_functions.h"

#include <dlfcn.h>

#include <filesystem>

namespace loopmend {

namespace {

const PictureFunctions& pictures() {
  static const PictureFunctions* functions = [] {
    try {
      const std::filesystem::path file = own_file("loopmend-pictures.so");
      void* module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
      void* function = module ? dlsym(module, picture_functions_name) : nullptr;
      if (!function) throw Error(say("%1 was not loaded (%2)", path_text(file), dlerror()));
      return reinterpret_cast<const PictureFunctions* (*)()>(function)();
    } catch (const Error& error) {
      throw Error(say("pictures cannot be drawn: %1", error.message()));
    }
  }();
  return *functions;
}

}  // namespace

std::string render_surface(const SurfaceModel& model, const RenderOptions& options) {
  return pictures().surface(model, options);
}

std::string render_before_after(const SurfaceModel& before, const SurfaceModel& after, const RenderOptions& options) {
  return pictures().before_after(before, after, options);
}

std::size_t render_film(std::ostream& out, const SurfaceModel& model, const std::vector<FilmState>& states,
                        const RenderOptions& options) {
  return pictures().film(out, model, states, options);
}

std::string render_panels(const std::vector<Panel>& panels, int columns, const RenderOptions& options) {
  return pictures().panels(panels, columns, options);
}

}  // namespace loopmend
