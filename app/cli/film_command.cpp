// SPDX-License-Identifier: GPL-3.0-or-later
// A film of the flow on one hole.
#include "commands.h"
#include "exit_codes.h"
#include "open_model.h"
#include "outputs.h"

#include "analysis/curvature_field.h"
#include "core/path_text.h"
#include "evolution/option_names.h"
#include "mesh/boundary_loops.h"
#include "pipeline/solve_group.h"
#include "scene/film.h"

#include <algorithm>
#include <cctype>
#include <cstdio>

namespace loopmend {

namespace {

/// @throws UsageError where there is no such hole.
const BoundaryLoop& filmed_loop(const std::vector<BoundaryLoop>& loops, const std::optional<int>& number) {
  for (const BoundaryLoop& loop : loops)  // by falling perimeter
    if (number ? loop.number == *number : loop.kind == LoopKind::hole) return loop;
  throw UsageError(number ? "there is no loop " + std::to_string(*number) + ": the surface has " +
                                std::to_string(loops.size())
                          : std::string("the surface has no hole, so there is no flow to be filmed"));
}

std::size_t size_of(const SurfaceShape& shape) {
  return sizeof(float) * (shape.points.size() + shape.normals.size() + shape.H.size() + shape.K.size()) +
         sizeof(int) * shape.triangles.size();
}

/// The accepted states of the last attempt. Where they take too much memory, every second of the inner ones goes.
class FilmRecording {
 public:
  FilmRecording(Vec3 origin, std::string flow) : origin_(std::move(origin)), flow_(std::move(flow)) {}

  void begin(const Patch& initial) { states_ = {made(initial, "Initial patch")}; }
  void step(const Evolution& evolution, const StepRecord& record) {
    if (record.step == 1) states_.resize(1);
    last_step_ =
        caption(method_name(evolution.method(), evolution.options().flow)) + ", step " + std::to_string(record.step);
    states_.push_back(made(evolution.patch(), last_step_));
    thin_out();
  }
  /// @param result  what the steps have led to, or what took their place
  void end(const PatchResult& result) {
    if (result.status == PatchStatus::filled) states_.resize(1);  // the steps were thrown away
    const std::string method = caption(method_name(result));
    const bool by_steps = states_.size() > 1 && last_step_.rfind(method + ", ", 0) == 0;
    if (by_steps) states_.pop_back();  // the last step comes as the result
    states_.push_back(made(result.patch, (by_steps ? last_step_ : method) + ", the result"));
  }
  const std::vector<FilmState>& states() const { return states_; }

 private:
  static constexpr std::size_t budget = std::size_t{256} << 20U;

  /// "MMCVF split", "Linear fairing"
  std::string caption(std::string method) const {
    std::replace(method.begin(), method.end(), '_', ' ');
    const std::size_t capitals = method.rfind(flow_, 0) == 0 ? flow_.size() : 1;
    for (std::size_t k = 0; k < std::min(capitals, method.size()); ++k)
      method[k] = static_cast<char>(std::toupper(static_cast<unsigned char>(method[k])));
    return method;
  }
  FilmState made(const Patch& patch, const std::string& state) const {
    return {shape_of(patch, origin_), state + ": mean curvature"};
  }
  void thin_out() {
    std::size_t bytes = 0;
    for (const FilmState& state : states_) bytes += size_of(*state.patch);
    if (bytes <= budget || states_.size() < 4) return;
    std::vector<FilmState> kept;
    for (std::size_t k = 0; k < states_.size(); ++k)
      if (k % 2 == 0 || k + 1 == states_.size()) kept.push_back(states_[k]);
    states_ = std::move(kept);
  }

  Vec3 origin_;
  std::string flow_, last_step_;
  std::vector<FilmState> states_;
};

struct FilmedFill {
  std::vector<FilmState> states;
  std::string method;
};

/// @throws Error where the hole cannot be filled.
FilmedFill filmed_fill(const SurfaceModel& model, const BoundaryLoop& loop, const RenderCommand& command) {
  GroupOptions options;
  options.evolution->flow = value_named(flow_names, command.flow).value();
  options.evolution->mode = value_named(mode_names, command.mode).value();
  options.evolution->sigma = command.sigma;
  const ScanIndex scan(model);
  const InitialPatch initial = make_surveyed_patch(model, {loop}, options.initial, {});
  const auto refuse = [&](const Message& why) {
    throw Error(say("loop %1 cannot be filled, so there is no film: %2.", loop.number, why));
  };
  if (!initial.patch) refuse(initial.message());
  FilmRecording recording(scene_origin(model.soup), command.flow);
  recording.begin(*initial.patch);
  SolveObserver observer;
  observer.on_step = [&](const Evolution& evolution, const StepRecord& record) { recording.step(evolution, record); };
  const GroupResult group = solve_group(scan, initial, options, observer, {});
  if (group.patches.empty()) refuse(group.holes.front().message);
  recording.end(*group.patches.front());
  return {recording.states(), method_name(*group.patches.front())};
}

}  // namespace

int run_film(const RenderCommand& command, RenderOptions options) {
  if (command.inputs.size() != 1) throw UsageError("--film takes one mesh");
  CommandFiles files;
  files.reads("the input", command.inputs.front());
  files.writes(NamedFile::Kind::film, "--film", command.film).check();
  const SurfaceModel model = open_model(command.inputs.front()).model;
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  const BoundaryLoop& loop = filmed_loop(loops, command.loop);
  options.loop = loop.number;
  if (command.width == 0) {
    options.width = 800;
    options.height = 600;
  }
  const FilmedFill fill = filmed_fill(model, loop, command);
  std::size_t shown = 0;
  OutputTransaction outputs;
  outputs.add(command.film, [&](std::ostream& out) { shown = render_film(out, model, fill.states, options); });
  outputs.commit();
  std::printf("%s: %d x %d pixels, %zu states of the patch on loop %d, made by %s\n", path_text(command.film).c_str(),
              options.width, options.height, shown, loop.number, fill.method.c_str());
  return exit_done;
}

}  // namespace loopmend
