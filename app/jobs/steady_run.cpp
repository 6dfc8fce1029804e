// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/steady_run.h"

#include "analysis/curvature_field.h"
#include "core/error.h"
#include "document/timeline.h"
#include "jobs/state_making.h"
#include "pipeline/blend.h"

#include <algorithm>

namespace loopmend {
namespace {

/// How long a step is shown where one patch is watched; several share it.
constexpr std::chrono::milliseconds watched_step{250};

/// More patches than this appear when they are done: nobody can follow the steps of so many.
constexpr std::size_t most_live = 40;

/// What was done in place of the flow, and why; then what is to be said of the result.
std::string message_of(const PatchResult& result) {
  const char* method = [&] {
    switch (result.method) {
      case Method::robust_fairing: return "robust fairing in place of the flow";
      case Method::linear_fairing: return "linear fairing in place of the flow";
      case Method::split_flow: return result.reason.empty() ? "the flow on the smooth surface under the scan" : "";
      case Method::mixed_order: return "the flow with bending energy mixed in";
      case Method::initial_patch:
      case Method::flow: break;
    }
    return "";
  }();
  std::string text;
  for (const std::string& part : {std::string(method), result.reason, result.message})
    if (!part.empty()) text += (text.empty() ? "" : text == method ? ": " : "; ") + part;
  return text;
}

}  // namespace

SteadyRun::SteadyRun(const EvolveTask& task, const EvolveTask::Item& item, RunRecorder& recorder, const Job& job)
    : task_(task),
      item_(item),
      recorder_(recorder),
      job_(job),
      last_(item.patch.state) {}

void SteadyRun::show(const Evolution& evolution, const StepRecord& record) {
  const PatchState& start = *item_.patch.state;
  if (evolution.patch().loop_numbers != start.patch.loop_numbers) return;  // only a part of what is shown
  if (task_.pace != Pace::watched && task_.items.size() > most_live) return;
  if (record.step == 1) {
    if (attempts_++ > 0) recorder_.restart(item_.patch.id);
    initial_energy_ = evolution.initial_energy();
    last_ = item_.patch.state;
  }
  auto next = with_patch(start, evolution.patch(), task_.origin);
  next->status = PatchStatus::ready;
  next->energy = {initial_energy_, record.energy};
  next->message.clear();
  next->flow = task_.options.flow;
  next->method = evolution.method();
  next->steps = start.steps + record.step;
  next->last_step = record;
  next->seconds.total = std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
  const bool first_attempt = attempts_ == 1;
  RunRecipe run = recipe_of(task_.options);
  run.relief = {};  // added at the end
  run.steps = record.step;
  run.end = first_attempt ? RunRecipe::End::after_steps : RunRecipe::End::unnamed;
  next->recipe.runs.push_back(run);
  last_ = next;
  recorder_.record(item_.patch.id, std::move(next));
  if (task_.pace == Pace::watched) job_.linger(watched_step / std::max<std::size_t>(1, task_.items.size()));
}

PatchStatePtr SteadyRun::state_of(const PatchResult& result, const PatchState& from) {
  const PatchState& start = *item_.patch.state;
  auto state = std::make_shared<PatchState>(from);
  const std::vector<SeamReport> before = from.seams_before;
  static_cast<PatchResult&>(*state) = result;
  state->history.clear();
  state->seams_before = before;
  state->message = message_of(result);
  state->shape = std::make_shared<SurfaceShape>(
      shape_of(result.patch, curvature_field(result.patch), task_.origin, item_.site->colors()));
  state->recipe = start.recipe;
  RunRecipe run = recipe_of(task_.options);
  run.steps = result.steps;
  state->recipe.runs.push_back(run);
  state->steps = start.steps + result.steps;
  state->seconds.total = std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
  return state;
}

std::vector<OpenPatch> SteadyRun::run() {
  const PatchState& start = *item_.patch.state;
  InitialPatch initial;
  initial.patch = start.patch;
  initial.loops = item_.loops;
  if (!start.recipe.runs.empty()) initial.origin = InitialPatch::Origin::evolved;
  const GroupOptions options{InitialPatchOptions{start.recipe.density}, task_.options};
  if (start.recipe.start == PatchRecipe::Start::bridge && start.recipe.runs.empty()) return run_bridge();
  const GroupResult group = solve_group(
      item_.site->site(), initial, options,
      [this](const Evolution& evolution, const StepRecord& record) { show(evolution, record); }, job_.pause_token());
  if (job_.token().cancelled() || job_.asked_to_pause()) return {};
  if (group.patches.empty()) throw InvalidArgument(group.holes.front().message);
  if (group.patches.size() == 1 && group.patches.front()->patch.loops.size() == start.patch.loops.size()) {
    finish(*group.patches.front());
    return {};
  }
  std::vector<OpenPatch> parts;
  for (const auto& result : group.patches) parts.push_back(part(result->patch.loop_numbers, result.get(), ""));
  for (const HoleResult& hole : group.holes)
    if (!hole.patch) parts.push_back(part({hole.loop.number}, nullptr, hole.message));
  if (job_.pause_token().cancelled()) return {};
  return parts;
}

void SteadyRun::finish(const PatchResult& result) {
  PatchStatePtr state = state_of(result, *last_);
  if (result.status == PatchStatus::filled) {
    recorder_.restart(item_.patch.id);
    recorder_.record(item_.patch.id, std::move(state));
  } else {
    recorder_.amend(item_.patch.id, std::move(state));
  }
}

std::vector<OpenPatch> SteadyRun::run_bridge() {
  const InitialPatchOptions options{item_.patch.state->recipe.density};
  const BridgeOutcome outcome = bridge_loops(item_.site->model(), item_.loops, options, job_.pause_token());
  if (job_.pause_token().cancelled()) return {};
  if (!outcome.bridge) throw InvalidArgument(outcome.message);
  const PatchResult result = solve_bridge(
      item_.site->site(), *outcome.bridge, task_.options,
      [this](const Evolution& evolution, const StepRecord& record) { show(evolution, record); }, job_.pause_token());
  if (job_.token().cancelled() || job_.asked_to_pause()) return {};
  if (result.status == PatchStatus::failed) throw InvalidArgument(result.message);
  finish(result);
  return {};
}

std::vector<BoundaryLoop> SteadyRun::loops_of(const std::vector<int>& numbers) const {
  std::vector<BoundaryLoop> loops;
  for (const BoundaryLoop& loop : item_.loops)
    if (std::find(numbers.begin(), numbers.end(), loop.number) != numbers.end()) loops.push_back(loop);
  return loops;
}

OpenPatch SteadyRun::part(const std::vector<int>& numbers, const PatchResult* result, const std::string& why_not) {
  const double density = item_.patch.state->recipe.density;
  const std::vector<BoundaryLoop> loops = loops_of(numbers);
  OpenPatch part;
  part.scan = item_.patch.scan;
  for (std::size_t k = 0; k < item_.loops.size(); ++k)
    for (const BoundaryLoop& loop : loops)
      if (loop.number == item_.loops[k].number) part.loops.push_back(item_.patch.loops[k]);
  InitialPatch initial =
      make_initial_patch(item_.site->model(), loops, InitialPatchOptions{density}, job_.pause_token());
  Patch first_patch = initial.patch ? std::move(*initial.patch) : result ? result->patch : Patch();
  auto first = std::make_shared<PatchState>(
      *first_state(std::move(first_patch), initial.message(), density, task_.origin, item_.site->colors()));
  if (!result) first->message = why_not;
  part.state = result ? state_of(*result, *first) : first;
  part.timeline = std::make_shared<Timeline>(result ? Timeline{first, part.state} : Timeline{first});
  return part;
}

}  // namespace loopmend
