#include "commands.h"
#include "exit_codes.h"
#include "open_model.h"

#include "scene/offscreen_render.h"

#include <cstdio>

namespace loopmend {

int run_render(const RenderCommand& command) {
  RenderOptions options;
  options.shading = command.color == "plain"   ? Shading::plain
                    : command.color == "zebra" ? Shading::zebra
                                               : Shading::curvature;
  if (command.width > 0) {
    options.width = command.width;
    options.height = command.height;
  }
  const SurfaceModel first = open_model(command.inputs[0]).model;
  if (command.inputs.size() == 1) {
    render_to_png(first, options, command.output);
  } else {
    const SurfaceModel second = open_model(command.inputs[1]).model;
    render_before_after(first, second, options, command.output);
  }
  std::printf("%s: %d x %d pixels\n", command.output.c_str(), options.width, options.height);
  return exit_done;
}

}  // namespace loopmend
