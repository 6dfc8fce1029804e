// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "exit_codes.h"
#include "open_model.h"
#include "outputs.h"

#include "scene/offscreen_render.h"

#include <cstdio>
#include <map>

namespace loopmend {

namespace {

RenderOptions options_of(const RenderCommand& command) {
  static const std::map<std::string, NamedView> views{{"front", NamedView::front}, {"back", NamedView::back},
                                                      {"left", NamedView::left},   {"right", NamedView::right},
                                                      {"top", NamedView::top},     {"bottom", NamedView::bottom},
                                                      {"iso", NamedView::iso}};
  RenderOptions options;
  options.shading = command.color == "plain"   ? Shading::plain
                    : command.color == "zebra" ? Shading::zebra
                                               : Shading::curvature;
  if (command.width > 0) {
    options.width = command.width;
    options.height = command.height;
  }
  if (!command.view.empty()) options.view = views.at(command.view);
  options.eye = command.direction;
  options.loop = command.loop;
  return options;
}

}  // namespace

int run_render(const RenderCommand& command) {
  CommandFiles files;
  for (const std::filesystem::path& input : command.inputs) files.reads("the input", input);
  files.writes(NamedFile::Kind::picture, "-o", command.output).check();
  const RenderOptions options = options_of(command);
  const SurfaceModel first = open_model(command.inputs[0]).model;
  const std::string png = command.inputs.size() == 1
                              ? render_surface(first, options)
                              : render_before_after(first, open_model(command.inputs[1]).model, options);
  OutputTransaction outputs;
  add_text(outputs, command.output, png);
  outputs.commit();
  std::printf("%s: %d x %d pixels\n", command.output.c_str(), options.width, options.height);
  return exit_done;
}

}  // namespace loopmend
