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

}  // namespace

Message message_of(const PatchResult& result) {
  Message method;
  switch (result.method) {
    case Method::robust_fairing: method = say("robust fairing in place of the flow"); break;
    case Method::sharp_edges: method = say("sharp edges continued in place of the flow"); break;
    case Method::linear_fairing: method = say("linear fairing in place of the flow"); break;
    case Method::split_flow:
      if (result.reason.empty()) method = say("the flow on the smooth surface under the scan");
      break;
    case Method::mixed_order: method = say("the flow with bending energy mixed in"); break;
    case Method::initial_patch:
    case Method::mirror_image:
    case Method::flow: break;
  }
  return joined(std::move(method), ": ", joined(result.reason, "; ", result.message));
}

InitialPatch initial_of(const EvolveTask::Item& item) {
  if (item.initial) return *item.initial;
  const PatchState& start = *item.patch.state;
  InitialPatch initial;
  initial.patch = start.patch;
  initial.loops = item.loops;
  if (!start.recipe.runs.empty()) initial.origin = InitialPatch::Origin::evolved;
  return initial;
}

SteadyRun::SteadyRun(const EvolveTask& task, const EvolveTask::Item& item, RunRecorder& recorder, const Job& job)
    : task_(task),
      item_(item),
      recorder_(recorder),
      job_(job),
      last_(item.patch.state) {}

void SteadyRun::show(const Evolution& evolution, const StepRecord& record) {
  if (task_.pace != Pace::watched && task_.items.size() > most_live) return;
  const PatchState& start = *item_.patch.state;
  if (record.step == 1) initial_energy_ = evolution.initial_energy();
  const std::vector<int>& numbers = evolution.patch().loop_numbers;
  if (numbers != start.patch.loop_numbers) {  // it becomes a patch of its own when it is done
    if (item_.loops.size() > most_live) return;
    Part& part = parts_[numbers];
    if (!part.first) part.first = first_of(numbers, nullptr);
    if (record.step == 1) {
      part.steps.clear();
      ++part.attempts;
    }
    auto next = after_step(*part.first, evolution, record);
    if (part.attempts > 1) next->recipe.runs.back().end = RunRecipe::End::unnamed;
    part.steps.push_back(std::move(next));
    return;
  }
  if (record.step == 1) {
    if (attempts_++ > 0) recorder_.restart(item_.patch.id);
    last_ = item_.patch.state;
  }
  auto next = after_step(start, evolution, record);
  if (attempts_ > 1) next->recipe.runs.back().end = RunRecipe::End::unnamed;
  last_ = next;
  recorder_.record(item_.patch.id, std::move(next));
  if (task_.pace == Pace::watched) job_.linger(watched_step / std::max<std::size_t>(1, task_.items.size()));
}

std::shared_ptr<PatchState> SteadyRun::after_step(const PatchState& start, const Evolution& evolution,
                                                  const StepRecord& record) {
  auto next = with_patch(start, evolution.patch(), task_.origin);
  next->status = PatchStatus::ready;
  next->energy = {initial_energy_, record.energy};
  next->message = {};
  next->flow = task_.options.flow;
  next->method = evolution.method();
  next->steps = start.steps + record.step;
  next->last_step = record;
  next->seconds.total = std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
  RunRecipe run = recipe_of(task_.options);
  run.relief = {};  // added at the end
  run.steps = record.step;
  run.end = RunRecipe::End::after_steps;
  next->recipe.runs.push_back(run);
  return next;
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
      shape_of(result.patch, curvature_field(result.patch), task_.origin, item_.scan_context->colors()));
  show_deviation(*state);
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
  const InitialPatch initial = initial_of(item_);
  const GroupOptions options = group_options(item_, task_.options);
  if (start.recipe.start == PatchRecipe::Start::bridge && start.recipe.runs.empty()) return run_bridge();
  const GroupResult group = solve_group(
      item_.scan_context->index(), initial, options,
      [this](const Evolution& evolution, const StepRecord& record) { show(evolution, record); }, job_.pause_token());
  if (job_.token().cancelled() || job_.asked_to_pause()) return {};
  if (group.patches.empty()) throw InvalidArgument(group.holes.front().message);
  if (group.patches.size() == 1 && group.patches.front()->patch.loops.size() == start.patch.loops.size()) {
    finish(*group.patches.front());
    return {};
  }
  std::vector<OpenPatch> parts;
  for (const auto& result : group.patches) parts.push_back(part(result->patch.loop_numbers, result.get(), {}));
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
  const BridgeOutcome outcome = bridge_loops(item_.scan_context->model(), item_.loops, options, job_.pause_token());
  if (job_.pause_token().cancelled()) return {};
  if (!outcome.bridge) throw InvalidArgument(outcome.message);
  const PatchResult result = solve_bridge(
      item_.scan_context->index(), *outcome.bridge, task_.options,
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

OpenPatch SteadyRun::part(const std::vector<int>& numbers, const PatchResult* result, const Message& why_not) {
  const std::vector<BoundaryLoop> loops = loops_of(numbers);
  OpenPatch part;
  part.scan = item_.patch.scan;
  for (std::size_t k = 0; k < item_.loops.size(); ++k)
    for (const BoundaryLoop& loop : loops)
      if (loop.number == item_.loops[k].number) part.loops.push_back(item_.patch.loops[k]);
  const Part known = parts_.contains(numbers) ? parts_.at(numbers) : Part{first_of(numbers, result), {}, 0};
  if (!result) {
    auto first = std::make_shared<PatchState>(*known.first);
    first->message = why_not;
    part.state = first;
    part.timeline = std::make_shared<Timeline>(Timeline{first});
    return part;
  }
  Timeline timeline{known.first};
  // What was thrown away for the initial patch is not a way to it. The last step comes as the result.
  const bool stepped = result->status != PatchStatus::filled && !known.steps.empty();
  if (stepped) timeline.insert(timeline.end(), known.steps.begin(), known.steps.end() - 1);
  part.state = state_of(*result, stepped ? *known.steps.back() : *known.first);
  timeline.push_back(part.state);
  part.timeline = std::make_shared<Timeline>(std::move(timeline));
  return part;
}

PatchStatePtr SteadyRun::first_of(const std::vector<int>& numbers, const PatchResult* result) {
  const double density = item_.patch.state->recipe.density;
  InitialPatch initial = make_initial_patch(item_.scan_context->model(), loops_of(numbers),
                                            InitialPatchOptions{density}, job_.pause_token());
  Patch patch = initial.patch ? std::move(*initial.patch) : result ? result->patch : Patch();
  return first_state(std::move(patch), initial.message(), density, task_.origin, item_.scan_context->colors());
}

}  // namespace loopmend
