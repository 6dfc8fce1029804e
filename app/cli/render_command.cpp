// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "core/path_text.h"
#include "exit_codes.h"
#include "open_model.h"
#include "outputs.h"

#include "appearance/scan_colors.h"
#include "scene/offscreen_render.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <vector>

namespace loopmend {

namespace {

/// @param models  to be rendered
Shading shading_of(const std::string& color, const std::vector<const SurfaceModel*>& models) {
  if (color == "scan") return Shading::scan;
  if (color == "plain") return Shading::plain;
  if (color == "zebra") return Shading::zebra;
  const bool own = color == "auto" && std::all_of(models.begin(), models.end(), [](const SurfaceModel* model) {
                     return !scan_colors(*model).at_vertices.empty();
                   });
  return own ? Shading::scan : Shading::curvature;
}

RenderOptions options_of(const RenderCommand& command) {
  static const std::map<std::string, NamedView> views{{"front", NamedView::front}, {"back", NamedView::back},
                                                      {"left", NamedView::left},   {"right", NamedView::right},
                                                      {"top", NamedView::top},     {"bottom", NamedView::bottom},
                                                      {"iso", NamedView::iso}};
  RenderOptions options;
  if (command.width > 0) {
    options.width = command.width;
    options.height = command.height;
  }
  if (!command.view.empty()) options.view = views.at(command.view);
  options.eye = command.direction;
  options.loop = command.loop;
  options.seams = command.seams;
  options.pace = {command.film_rate, command.film_length};
  return options;
}

}  // namespace

int run_render(const RenderCommand& command) {
  if (command.output.empty() == command.film.empty())
    throw UsageError("render writes a picture with -o, or a film with --film: give one of them");
  if (!command.film.empty()) return run_film(command, options_of(command));
  if (command.seams == Seams::shown && command.inputs.size() < 2)
    throw UsageError("--seams needs two meshes: that with holes, and that with patches");
  CommandFiles files;
  for (const std::filesystem::path& input : command.inputs) files.reads("the input", input);
  files.writes(NamedFile::Kind::picture, "-o", command.output).check();
  RenderOptions options = options_of(command);
  std::vector<SurfaceModel> models;
  for (const std::filesystem::path& input : command.inputs) models.push_back(open_model(input).model);
  std::vector<const SurfaceModel*> all;
  for (const SurfaceModel& model : models) all.push_back(&model);
  options.shading = shading_of(command.color, all);
  if (options.shading == Shading::scan || command.color == "auto")
    for (const SurfaceModel* model : all)
      for (const Message& problem : scan_colors(*model).problems)
        std::fprintf(stderr, "%s\n", problem.english().c_str());
  const std::string png =
      models.size() == 1 ? render_surface(models[0], options) : render_before_after(models[0], models[1], options);
  OutputTransaction outputs;
  add_text(outputs, command.output, png);
  outputs.commit();
  std::printf("%s: %d x %d pixels\n", path_text(command.output).c_str(), options.width, options.height);
  return exit_done;
}

}  // namespace loopmend
