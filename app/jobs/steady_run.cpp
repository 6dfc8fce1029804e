// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/steady_run.h"

#include "document/timeline.h"
#include "jobs/state_making.h"

namespace loopmend {
namespace {

PatchStage stage_of(LoopStatus status) {
  switch (status) {
    case LoopStatus::converged: return PatchStage::converged;
    case LoopStatus::faired: return PatchStage::faired;
    case LoopStatus::doubtful: return PatchStage::doubtful;
    case LoopStatus::step_limit: return PatchStage::stalled;
    default: return PatchStage::filled;
  }
}

/// What was done in place of the flow, and why; then what is to be said of the result.
std::string message_of(const Evolved& evolved) {
  const char* method = [&] {
    switch (evolved.method) {
      case Method::robust_fairing: return "robust fairing in place of the flow";
      case Method::linear_fairing: return "linear fairing in place of the flow";
      case Method::interpolated: return "between the flow's patch and robust fairing";
      case Method::mixed_order: return "the flow with bending energy mixed in";
      case Method::denoised_flow: return "the flow next to a surface without noise";
      case Method::initial_patch:
      case Method::flow: break;
    }
    return "";
  }();
  std::string text;
  for (const std::string& part : {std::string(method), evolved.reason, evolved.message})
    if (!part.empty()) text += (text.empty() ? "" : text == method ? ": " : "; ") + part;
  return text;
}

/// Worth another try, loop by loop.
bool is_spoilt(const PatchState& state) {
  return state.stage == PatchStage::filled || state.stage == PatchStage::cutting || state.stage == PatchStage::doubtful;
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
  if (record.step == 1) {
    if (attempts_++ > 0) recorder_.restart(item_.patch.id);
    initial_energy_ = evolution.initial_energy();
    last_ = item_.patch.state;
  }
  auto next = with_patch(start, evolution.patch(), task_.origin);
  next->stage = PatchStage::stepped;
  next->message.clear();
  next->flow = task_.options.flow;
  next->steps = start.steps + record.step;
  next->last_step = record;
  next->initial_energy = initial_energy_;
  next->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
  const bool first_attempt = attempts_ == 1;
  RunRecipe run = recipe_of(task_.options);
  run.steps = record.step;
  run.end = first_attempt ? RunRecipe::End::after_steps : RunRecipe::End::unnamed;
  next->recipe.runs.push_back(run);
  last_ = next;
  recorder_.record(item_.patch.id, std::move(next));
}

Evolved SteadyRun::evolve(const PatchState& start) {
  const bool is_filler = start.recipe.runs.empty();
  return evolve_filler(
      item_.site->site(), start.patch, is_filler ? item_.loops : std::vector<BoundaryLoop>{}, task_.options,
      [this](const Evolution& evolution, const StepRecord& record) { show(evolution, record); }, job_.pause_token());
}

PatchStatePtr SteadyRun::state_of(const Evolved& evolved, const PatchState& from) {
  auto state = with_patch(from, evolved.patch, task_.origin);
  state->stage = stage_of(evolved.status);
  state->message = message_of(evolved);
  state->recipe = item_.patch.state->recipe;
  RunRecipe run = recipe_of(task_.options);
  run.steps = evolved.steps;
  state->recipe.runs.push_back(run);
  state->flow = task_.options.flow;
  state->steps = item_.patch.state->steps + evolved.steps;
  state->initial_energy = evolved.initial_energy;
  state->last_step.energy = evolved.final_energy;
  state->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
  return judged(std::move(state), nullptr, *item_.site);
}

std::vector<OpenPatch> SteadyRun::run() {
  const PatchState& start = *item_.patch.state;
  const bool may_be_parted = item_.loops.size() > 1 && start.recipe.runs.empty();
  if (may_be_parted && is_judged(task_.options)) {
    const std::vector<std::vector<int>> parts = parts_alike();
    if (job_.pause_token().cancelled()) return {};
    if (parts.size() > 1) return in_parts(parts);
  }
  const Evolved evolved = evolve(start);
  if (job_.token().cancelled() || job_.asked_to_pause()) return {};
  PatchStatePtr state = state_of(evolved, *last_);
  if (is_spoilt(*state) && may_be_parted) return in_parts(one_by_one());
  if (evolved.status == LoopStatus::filled) {
    recorder_.restart(item_.patch.id);
    recorder_.record(item_.patch.id, std::move(state));
  } else {
    recorder_.amend(item_.patch.id, std::move(state));
  }
  return {};
}

std::vector<std::vector<int>> SteadyRun::one_by_one() const {
  std::vector<std::vector<int>> parts;
  for (std::size_t k = 0; k < item_.loops.size(); ++k) parts.push_back({static_cast<int>(k)});
  return parts;
}

/// As the command line parts them: one hole does not decide for its neighbours.
std::vector<std::vector<int>> SteadyRun::parts_alike() const {
  const FillerOptions options{item_.patch.state->recipe.density};
  const SurfaceModel& model = item_.site->model();
  return groups_alike(model, item_.loops, start_patch(model, item_.loops, options, job_.pause_token()).fillers);
}

/// Each part as a patch of its own; where that is spoilt, its loops one by one.
std::vector<OpenPatch> SteadyRun::in_parts(const std::vector<std::vector<int>>& parts) {
  std::vector<OpenPatch> result;
  for (const std::vector<int>& members : parts) {
    std::optional<OpenPatch> part = solved(members);
    if (job_.pause_token().cancelled()) return {};
    if (!part) continue;
    if (members.size() == 1 || !is_spoilt(*part->state)) {
      result.push_back(std::move(*part));
      continue;
    }
    for (int k : members) {
      std::optional<OpenPatch> single = solved({k});
      if (job_.pause_token().cancelled()) return {};
      if (single) result.push_back(std::move(*single));
    }
  }
  return result;
}

/// @param members  indices into the item's loops. @returns empty when cancelled, or where there is no initial patch.
std::optional<OpenPatch> SteadyRun::solved(const std::vector<int>& members) {
  const double density = item_.patch.state->recipe.density;
  OpenPatch part;
  part.scan = item_.patch.scan;
  std::vector<BoundaryLoop> loops;
  for (int k : members) {
    loops.push_back(item_.loops[static_cast<std::size_t>(k)]);
    part.loops.push_back(item_.patch.loops[static_cast<std::size_t>(k)]);
  }
  PatchStart start = start_patch(item_.site->model(), loops, FillerOptions{density}, job_.pause_token());
  if (!start.patch || job_.pause_token().cancelled()) return std::nullopt;
  std::string remarks;
  for (const FillerOutcome& filler : start.fillers)
    if (!filler.message.empty()) remarks += (remarks.empty() ? "" : " ") + filler.message;
  const PatchStatePtr initial = first_state(*start.patch, remarks, density, task_.origin);
  const Evolved evolved =
      evolve_filler(item_.site->site(), *start.patch, loops, task_.options, nullptr, job_.pause_token());
  if (job_.pause_token().cancelled()) return std::nullopt;
  part.state = state_of(evolved, *initial);
  part.timeline = std::make_shared<Timeline>(Timeline{initial, part.state});
  return part;
}

}  // namespace loopmend
