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

  void begin(const Patch& initial) { states_ = {made(initial, "initial patch")}; }
  void step(const Evolution& evolution, const StepRecord& record) {
    if (record.step == 1) states_.resize(1);
    states_.push_back(made(evolution.patch(), "step " + std::to_string(record.step)));
    steps_ = record.step;
    thin_out();
  }
  /// @param result  what the steps have led to, or what took their place
  void end(const PatchResult& result) {
    if (result.status == PatchStatus::filled) states_.resize(1);  // the steps were thrown away
    std::string method = method_name(result);
    std::replace(method.begin(), method.end(), '_', ' ');
    const bool by_flow = method.rfind(flow_, 0) == 0;       // also its split and mixed forms
    if (by_flow && states_.size() > 1) states_.pop_back();  // the last step comes as the result
    states_.push_back(made(result.patch, by_flow ? "step " + std::to_string(steps_) + ", the result" : method));
  }
  const std::vector<FilmState>& states() const { return states_; }

 private:
  static constexpr std::size_t budget = std::size_t{256} << 20U;

  FilmState made(const Patch& patch, const std::string& what) const {
    std::string flow = flow_;
    for (char& c : flow) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return {std::make_shared<SurfaceShape>(shape_of(patch, curvature_field(patch), origin_)),
            flow + ", " + what + ": mean curvature"};
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
  std::string flow_;
  int steps_ = 0;
  std::vector<FilmState> states_;
};

/// @throws Error where the hole cannot be filled.
std::vector<FilmState> recorded_flow(const SurfaceModel& model, const BoundaryLoop& loop,
                                     const RenderCommand& command) {
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
  const GroupResult group =
      solve_group(scan, initial, options,
                  [&](const Evolution& evolution, const StepRecord& record) { recording.step(evolution, record); }, {});
  if (group.patches.empty()) refuse(group.holes.front().message);
  recording.end(*group.patches.front());
  return recording.states();
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
  const std::vector<FilmState> states = recorded_flow(model, loop, command);
  std::size_t shown = 0;
  OutputTransaction outputs;
  outputs.add(command.film, [&](std::ostream& out) { shown = render_film(out, model, states, options); });
  outputs.commit();
  std::printf("%s: %d x %d pixels, %zu states of the flow on loop %d\n", path_text(command.film).c_str(), options.width,
              options.height, shown, loop.number);
  return exit_done;
}

}  // namespace loopmend
