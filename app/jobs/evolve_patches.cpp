// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/evolve_patches.h"

#include "core/error.h"
#include "core/system_memory.h"
#include "core/threads.h"
#include "document/timeline.h"
#include "filling/patch_size.h"
#include "jobs/state_making.h"
#include "jobs/steady_run.h"

#include <QCoreApplication>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>

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
  Stepper(const EvolveTask& task, const EvolveTask::Item& item, RunRecorder& recorder)
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
    recorder_.amend(item_.patch.id, state_);
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
    recorder_.record(item_.patch.id, state_);
  }

  /// The run ended without a further step: only stage and words change.
  void close() {
    auto next = std::make_shared<PatchState>(*state_);
    set_outcome(*next);
    const bool recorded = state_ != item_.patch.state;
    state_ = std::move(next);
    recorded ? recorder_.amend(item_.patch.id, state_) : recorder_.record(item_.patch.id, state_);
  }

  void set_outcome(PatchState& next) const {
    next.status = evolution_->status();
    next.message = evolution_->message();
    next.energy.initial = initial_energy_;
    next.seconds.total = std::chrono::duration<double>(Clock::now() - started_).count();
  }

  const EvolveTask::Item& item_;
  PatchStatePtr state_;
  RunRecorder& recorder_;
  Vec3 origin_;
  Clock::time_point started_;
  std::shared_ptr<Evolution> evolution_;
  double initial_energy_ = 0;
  bool goes_on_ = false;
  bool at_rest_ = false;
};

class Drive {
 public:
  Drive(const EvolveTask& task, RunRecorder& recorder, const Job& job) : task_(task), recorder_(recorder), job_(job) {}

  EvolveResult go() {
    if (is_to_steady_state(task_.pace)) {
      parallel_for(0, static_cast<int>(task_.items.size()), 1, [this](int k) {
        settle(task_.items[static_cast<std::size_t>(k)]);
        if (task_.progress) task_.progress(++done_);
      });
    } else {
      step_all();
    }
    return std::move(result_);
  }

 private:
  bool stopped() const { return job_.token().cancelled() || job_.asked_to_pause(); }

  /// @returns whether there is nothing that a flow could move; the state then says so.
  bool rigid(const EvolveTask::Item& item) {
    if (item.patch.state->patch.free_count > 0) return false;
    auto same_state = std::make_shared<PatchState>(*item.patch.state);
    same_state->message = say("too small to hold a free vertex: closed by triangles between its own vertices");
    recorder_.record(item.patch.id, same_state);
    return true;
  }

  /// @returns whether the patch needs more memory than there is; it then stays as it is.
  bool too_large(const EvolveTask::Item& item) {
    const double needed = memory_mb_of(item.patch.state->patch.free_count);
    if (needed <= memory_left_mb({})) return false;
    fail(item.patch.id,
         say("the flow would take about %1 MB of memory, more than is free; a smaller Density needs less",
             std::lround(needed)));
    return true;
  }

  void fail(int id, const Message& why) {
    const std::lock_guard lock(mutex_);
    result_.failures[id] = why;
  }

  /// The same item, or, where its holes ask for different treatment, an item for each part; what is known of them with them.
  std::vector<EvolveTask::Item> parts_of(const EvolveTask::Item& item) const {
    const PatchRecipe& recipe = item.patch.state->recipe;
    const bool whole =
        item.loops.size() == 1 || item.initial || !recipe.runs.empty() || recipe.start == PatchRecipe::Start::bridge;
    if (whole) return {item};
    std::vector<InitialPatch> parts = parts_alike(item.scan_context->index(), initial_of(item),
                                                  group_options(item, task_.options), job_.pause_token());
    if (parts.size() == 1) {
      EvolveTask::Item same = item;
      same.initial = std::move(parts.front());
      return {same};
    }
    if (std::any_of(parts.begin(), parts.end(), [](const InitialPatch& part) { return !part.patch; })) return {item};
    std::vector<EvolveTask::Item> items;
    for (InitialPatch& part : parts) {
      EvolveTask::Item& next = items.emplace_back();
      next.scan_context = item.scan_context;
      next.loops = part.loops;
      next.patch.id = item.spare_ids[items.size() - 1];
      next.patch.scan = item.patch.scan;
      for (std::size_t k = 0; k < item.loops.size(); ++k)
        if (std::any_of(part.loops.begin(), part.loops.end(),
                        [&](const BoundaryLoop& loop) { return loop.number == item.loops[k].number; }))
          next.patch.loops.push_back(item.patch.loops[k]);
      next.patch.state =
          judged(first_state(*part.patch, part.message(), recipe.density, task_.origin, item.scan_context->colors()),
                 nullptr, *item.scan_context);
      next.patch.timeline = start_timeline(next.patch.state);
      next.initial = std::move(part);
    }
    return items;
  }

  void settle(const EvolveTask::Item& item) {
    if (stopped() || too_large(item)) return;
    try {
      const std::vector<EvolveTask::Item> items = parts_of(item);
      if (stopped()) return;
      if (items.size() > 1) {
        std::vector<OpenPatch> patches;
        for (const EvolveTask::Item& part : items) patches.push_back(part.patch);
        recorder_.divide(item.patch.id, std::move(patches));
        for (const EvolveTask::Item& part : items) settle(part);
        return;
      }
      std::vector<OpenPatch> parts = SteadyRun(task_, items.front(), recorder_, job_).run();
      const std::lock_guard lock(mutex_);
      if (!parts.empty()) result_.splits[item.patch.id] = std::move(parts);
    } catch (const std::exception& error) {
      fail(item.patch.id, message_of(error));
    }
  }

  /// In rounds: one step of every patch that is not at its end.
  void step_all() {
    std::vector<std::pair<int, Stepper>> steppers;
    for (const EvolveTask::Item& item : task_.items) {
      if (stopped()) break;
      if (rigid(item) || too_large(item)) continue;
      try {
        steppers.emplace_back(item.patch.id, Stepper(task_, item, recorder_));
      } catch (const std::exception& error) {
        fail(item.patch.id, message_of(error));
      }
    }
    const auto moving = [&] {
      return std::any_of(steppers.begin(), steppers.end(), [](const auto& entry) { return !entry.second.at_rest(); });
    };
    while (moving() && !stopped()) {
      parallel_for(0, static_cast<int>(steppers.size()), 1, [&](int k) {
        Stepper& stepper = steppers[static_cast<std::size_t>(k)].second;
        if (!stopped() && !stepper.at_rest()) stepper.step(job_.token());
      });
      if (task_.pace == Pace::time_step) break;
    }
    for (auto& [id, stepper] : steppers) {
      if (job_.token().cancelled()) return;
      stepper.judge();
      result_.sessions[id] = stepper.session();
    }
  }

  const EvolveTask& task_;
  RunRecorder& recorder_;
  const Job& job_;
  std::mutex mutex_;
  std::atomic<int> done_ = 0;
  EvolveResult result_;
};

}  // namespace

EvolveResult evolve_patches(const EvolveTask& task, RunRecorder& recorder, const Job& job) {
  return Drive(task, recorder, job).go();
}

}  // namespace loopmend
