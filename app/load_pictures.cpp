// SPDX-License-Identifier: GPL-3.0-or-later
// In place of the scene's pictures, for the command line: the module that draws them is loaded when a picture is asked for, so that
// other commands start without VTK.
#include "core/error.h"
#include "core/path_text.h"
#include "picture_functions.h"

#include <dlfcn.h>

#include <filesystem>

namespace loopmend {

namespace {

/// Beside the program, as it was built, or where it is installed.
std::filesystem::path module_file() {
  const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  const std::filesystem::path built = folder / LOOPMEND_PICTURES_MODULE;
  return exists(built) ? built : (folder / LOOPMEND_PICTURES_FOLDER / LOOPMEND_PICTURES_MODULE).lexically_normal();
}

const PictureFunctions& pictures() {
  static const PictureFunctions* functions = [] {
    const std::filesystem::path file = module_file();
    if (!exists(file))
      throw Error(say("pictures cannot be drawn: %1 is missing. In Debian's packages it is in loopmend-pictures.",
                      path_text(file)));
    void* module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* function = module ? dlsym(module, picture_functions_name) : nullptr;
    if (!function) throw Error(say("pictures cannot be drawn: %1 was not loaded (%2).", path_text(file), dlerror()));
    return reinterpret_cast<const PictureFunctions* (*)()>(function)();
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
