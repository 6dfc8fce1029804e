// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/step_patches.h"

#include "core/error.h"
#include "core/seconds_since.h"
#include "core/system_memory.h"
#include "core/threads.h"
#include "filling/patch_size.h"
#include "jobs/state_making.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace loopmend {
namespace {

using Clock = std::chrono::steady_clock;

bool same(const EvolutionOptions& a, const EvolutionOptions& b) {
  return a.flow == b.flow && a.mode == b.mode && a.sigma == b.sigma && a.solver == b.solver && a.bending == b.bending &&
         a.boundary == b.boundary && a.continuity == b.continuity;
}

/// One patch under way, step by step.
class Stepper {
 public:
  Stepper(const StepTask& task, const StepTask::Item& item, RunRecorder& recorder)
      : item_(item),
        state_(item.patch.state),
        recorder_(recorder),
        origin_(task.origin),
        started_(Clock::now()) {
    if (item.session) {
      evolution_ = item.session;
      // Only other options make another run: the same ones go on as if there had been no pause, as the command would.
      goes_on_ = same(evolution_->options(), task.options) && evolution_->status() == PatchStatus::ready;
      if (!goes_on_) evolution_->set_options(task.options);
    } else {
      evolution_ = std::make_shared<Evolution>(state_->patch, task.options);
    }
    initial_energy_ = goes_on_ ? state_->energy.initial : evolution_->energy();
  }

  bool at_rest() const { return at_rest_; }

  void step(const CancelToken& cancel) {
    const std::size_t before = evolution_->history().size();
    evolution_->step(cancel);
    if (cancel.cancelled()) return;
    const bool moved = evolution_->history().size() > before;
    at_rest_ = !moved || evolution_->status() != PatchStatus::ready;
    moved ? publish(evolution_->history().back()) : close();
  }

  /// At the end of the run: does it cut or fold?
  void judge() {
    if (state_ == item_.patch.state) return;
    const Patch& initial = item_.patch.timeline->front()->patch;
    const bool bridge = state_->recipe.start == PatchRecipe::Start::bridge;
    PatchStatePtr marked =
        with_verdicts(judged(state_, &initial, *item_.scan_context), initial,
                      bridge ? std::vector<BoundaryLoop>() : item_.loops, evolution_->options(), *item_.scan_context);
    if (marked == state_) return;
    state_ = std::move(marked);
    recorder_.amend(loops_of(item_.patch), state_);
  }

  EvolutionSession session() const { return {evolution_, state_}; }

 private:
  void publish(const StepRecord& record) {
    auto next = with_patch(*state_, evolution_->patch(), origin_);
    const EvolutionOptions& options = evolution_->options();
    next->flow = options.flow;
    next->method = evolution_->method();
    next->steps = state_->steps + 1;
    next->last_step = record;
    next->energy.final = record.energy;
    if (std::exchange(goes_on_, true) && !next->recipe.runs.empty()) {
      ++next->recipe.runs.back().steps;
    } else {
      RunRecipe run = recipe_of(options);
      run.steps = 1;
      run.end = RunRecipe::End::after_steps;
      next->recipe.runs.push_back(run);
    }
    set_outcome(*next);
    state_ = std::move(next);
    recorder_.record(loops_of(item_.patch), state_);
  }

  /// The run ended without a further step: only stage and words change.
  void close() {
    auto next = std::make_shared<PatchState>(*state_);
    set_outcome(*next);
    const bool recorded = state_ != item_.patch.state;
    state_ = std::move(next);
    recorded ? recorder_.amend(loops_of(item_.patch), state_) : recorder_.record(loops_of(item_.patch), state_);
  }

  void set_outcome(PatchState& next) const {
    next.status = evolution_->status();
    next.message = evolution_->message();
    next.energy.initial = initial_energy_;
    next.seconds.total = seconds_since(started_);
  }

  const StepTask::Item& item_;
  PatchStatePtr state_;
  RunRecorder& recorder_;
  Vec3 origin_;
  Clock::time_point started_;
  std::shared_ptr<Evolution> evolution_;
  double initial_energy_ = 0;
  bool goes_on_ = false;
  bool at_rest_ = false;
};

/// @returns whether there is nothing that a flow could move; the state then says so.
bool is_rigid(const StepTask::Item& item, RunRecorder& recorder) {
  if (item.patch.state->patch.free_count > 0) return false;
  auto same_state = std::make_shared<PatchState>(*item.patch.state);
  same_state->message = say("too small to hold a free vertex: closed by triangles between its own vertices");
  recorder.record(loops_of(item.patch), same_state);
  return true;
}

/// @throws Error where the patch needs more memory than there is.
void check_size(const StepTask::Item& item) {
  const double needed = memory_mb_of(item.patch.state->patch.free_count);
  if (needed > memory_left_mb({}))
    throw Error(say("the flow would take about %1 MB of memory, more than is free; a smaller Density needs less",
                    std::lround(needed)));
}

}  // namespace

/// In rounds: one step of every patch that is not at its end.
StepResult step_patches(const StepTask& task, RunRecorder& recorder, const Job& job) {
  StepResult result;
  const auto stopped = [&] { return job.pause_token().cancelled(); };
  std::vector<std::pair<int, Stepper>> steppers;
  for (const StepTask::Item& item : task.items) {
    if (stopped()) break;
    try {
      if (is_rigid(item, recorder)) continue;
      check_size(item);
      steppers.emplace_back(item.patch.id, Stepper(task, item, recorder));
    } catch (const std::exception& error) {
      result.failures[item.patch.loops.front()] = message_of(error);
    }
  }
  const auto moving = [&] {
    return std::any_of(steppers.begin(), steppers.end(), [](const auto& entry) { return !entry.second.at_rest(); });
  };
  while (moving() && !stopped()) {
    parallel_for(0, static_cast<int>(steppers.size()), 1, [&](int k) {
      Stepper& stepper = steppers[k].second;
      if (!stopped() && !stepper.at_rest()) stepper.step(job.token());
    });
    if (task.pace == Pace::time_step) break;
  }
  for (auto& [id, stepper] : steppers) {
    if (job.token().cancelled()) return result;
    stepper.judge();
    result.sessions[id] = stepper.session();
  }
  return result;
}

}  // namespace loopmend
