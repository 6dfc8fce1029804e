// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/fill_run.h"

#include "core/seconds_since.h"
#include "core/system_memory.h"
#include "filling/patch_size.h"
#include "jobs/remaining_time.h"
#include "jobs/state_making.h"

#include <algorithm>
#include <chrono>
#include <mutex>

namespace loopmend {
namespace {

using Clock = std::chrono::steady_clock;

/// How long a step is shown where one patch is watched; several share it.
constexpr std::chrono::milliseconds watched_step{250};

/// The wanted loops, and those that were filled before and lie so near that they are solved jointly.
std::vector<BoundaryLoop> with_neighbors(const FillTask& task, const std::map<int, BoundaryLoop>& wanted) {
  std::vector<BoundaryLoop> all, nearby;
  for (const auto& [index, loop] : wanted) all.push_back(loop);
  const auto first_filled = static_cast<int>(all.size());
  if (task.filled.empty() || wanted.empty()) return all;
  for (const auto& [index, loop] : task.filled)
    if (!wanted.contains(index)) all.push_back(loop);
  for (const std::vector<int>& group : group_loops(task.scan_context->model(), all))
    if (std::any_of(group.begin(), group.end(), [&](int k) { return k < first_filled; }))
      for (int k : group) nearby.push_back(all[k]);
  std::sort(nearby.begin(), nearby.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
  return nearby;
}

/// What the engine says of the holes of one task, as states that can be shown.
class TaskRecording {
 public:
  TaskRecording(const FillRun& run, const FillTask& task, RunRecorder& recorder, const Job& job, FillOutcome& outcome)
      : run_(run),
        task_(task),
        recorder_(recorder),
        job_(job),
        outcome_(outcome),
        live_(run.pace == Pace::watched || run.loops() <= most_live) {}

  SolveObserver observer() {
    return {[this](const StartPatch& start) { begin(start); },
            [this](const Evolution& evolution, const StepRecord& record) { show(evolution, record); },
            [this](const GroupResult& result) { end(result); }};
  }

  void go_on_from(const PatchStatePtr& moved) { parts_[loops_of(moved->patch)].first = moved; }

 private:
  struct Part {
    PatchStatePtr first;  ///< null where no flow follows
    PatchRecipe::Start start = PatchRecipe::Start::holes;
    double initial_energy = 0;
    int attempts = 0;
  };

  int index_of(int number) const { return task_.first_loop + number - 1; }

  std::set<int> loops_of(const Patch& patch) const {
    std::set<int> loops;
    for (int number : patch.loop_numbers) loops.insert(index_of(number));
    return loops;
  }

  Part* part_of(const std::set<int>& loops) {
    const std::lock_guard lock(mutex_);
    const auto found = parts_.find(loops);
    return found == parts_.end() ? nullptr : &found->second;
  }

  bool is_asked_for(const std::set<int>& loops) {
    const auto is_wanted = [this](int loop) { return task_.wanted.contains(loop); };
    return part_of(loops) || std::any_of(loops.begin(), loops.end(), is_wanted);
  }

  std::shared_ptr<PatchState> initial_state(const Patch& patch, PatchRecipe::Start start) const {
    return first_state(patch, {task_.options.initial.density, start, {}}, run_.origin, task_.scan_context->colors());
  }

  void begin(const StartPatch& start) {
    const std::set<int> loops = loops_of(start.patch);
    if (!is_asked_for(loops)) return;
    if (run_.expects && task_.options.evolution) {
      flow_started_ = Clock::now();
      const double seconds = std::chrono::duration<double>(flow_started_ - started_).count();
      run_.expects(seconds * (1 - share_of_initial_patch) / share_of_initial_patch);
    }
    Part part;
    if (start.kind == StartPatch::Kind::bridge) part.start = PatchRecipe::Start::bridge;
    if (task_.options.evolution) {
      const auto first = initial_state(start.patch, part.start);
      first->message = start.message;
      recorder_.start(loops, first);
      part.first = first;
    }
    const std::lock_guard lock(mutex_);
    parts_[loops] = part;
  }

  void show(const Evolution& evolution, const StepRecord& record) {
    const std::set<int> loops = loops_of(evolution.patch());
    Part* part = part_of(loops);
    if (!part || !live_) return;
    if (run_.expects) {
      const double seconds = seconds_since(flow_started_);
      run_.expects(steps_left(record.step) * seconds / record.step);
    }
    if (record.step == 1) {
      part->initial_energy = evolution.initial_energy();
      if (part->attempts++ > 0) recorder_.restart(loops);
    }
    recorder_.record(loops, after_step(*part, evolution, record));
    if (run_.pace == Pace::watched) job_.linger(watched_step / std::max(1, run_.patches));
  }

  RunRecipe recipe() const {
    RunRecipe run = recipe_of(*task_.options.evolution);
    if (!task_.options.mirror_planes.empty()) {
      run.mirror = RunRecipe::Mirror::placed;
      run.mirror_plane = task_.options.mirror_planes.front();
    }
    return run;
  }

  PatchStatePtr after_step(const Part& part, const Evolution& evolution, const StepRecord& record) const {
    auto next = with_patch(*part.first, evolution.patch(), run_.origin);
    next->status = PatchStatus::ready;
    next->energy = {part.initial_energy, record.energy};
    next->message = {};
    next->flow = evolution.options().flow;
    next->method = evolution.method();
    next->steps = part.first->steps + record.step;
    next->last_step = record;
    next->seconds.total = seconds_since(started_);
    RunRecipe run = recipe();
    run.relief = {};  // added at the end
    run.steps = record.step;
    run.end = part.attempts > 1 ? RunRecipe::End::unnamed : RunRecipe::End::after_steps;
    next->recipe.runs.push_back(run);
    return next;
  }

  /// @param said  of its holes
  void end(const PatchResult& result, const Message& said) {
    const std::set<int> loops = loops_of(result.patch);
    if (!is_asked_for(loops)) return;
    const Part part = part_of(loops) ? *part_of(loops) : Part();
    std::shared_ptr<PatchState> state;
    const PatchStatePtr first = part.first ? part.first : state = initial_state(result.patch, part.start);
    if (task_.options.evolution) {
      state = with_result(*first, result, recipe(), run_.origin);
    } else {  // without a verdict: a flow may follow
      state->status = result.status;
      state->validity = result.validity;
      state->neighborhood = result.neighborhood;
      state->message = said;
    }
    if (result.status == PatchStatus::filled) recorder_.restart(loops);
    recorder_.amend(loops, std::move(state));
  }

  void end(const GroupResult& result) {
    for (const auto& patch : result.patches) {
      Message said;
      for (const HoleResult& hole : result.holes)
        if (hole.patch == patch) said = joined(std::move(said), "; ", hole.message);
      end(*patch, said);
    }
    const std::lock_guard lock(mutex_);
    for (const HoleResult& hole : result.holes) {
      const int index = index_of(hole.loop.number);
      if (!hole.patch && hole.status == PatchStatus::failed)
        outcome_.failures[index] =
            hole.message.empty() ? say("no valid triangulation of this loop was found") : hole.message;
      else if (!hole.message.empty() && hole.message != hole.outcome().message)
        outcome_.remarks[index] = hole.message;
    }
  }

  const FillRun& run_;
  const FillTask& task_;
  RunRecorder& recorder_;
  const Job& job_;
  FillOutcome& outcome_;
  const bool live_;
  const Clock::time_point started_ = Clock::now();
  Clock::time_point flow_started_ = started_;
  std::mutex mutex_;
  std::map<std::set<int>, Part> parts_;  ///< by loops
};

}  // namespace

int FillRun::loops() const {
  std::size_t count = 0;
  for (const FillTask& task : tasks) {
    count += task.wanted.size();
    for (const auto& [state, loops] : task.moved) count += loops.size();
  }
  return static_cast<int>(count);
}

double FillRun::work() const {
  double sum = 0;
  for (const FillTask& task : tasks) {
    for (const auto& [index, loop] : task.wanted) sum += work_of(loop);
    for (const auto& [state, loops] : task.moved)
      for (const BoundaryLoop& loop : loops) sum += work_of(loop);
  }
  return sum;
}

namespace {

/// Of the vertices that the patches will have.
double expected_seconds(const FillRun& run, const FillTask& task) {
  double vertices = 0;
  for (const auto& [index, loop] : task.wanted)
    vertices += expected_new_vertices(task.scan_context->model(), loop, task.options.initial.density);
  for (const auto& [state, loops] : task.moved)
    vertices += (1 - share_of_initial_patch) * static_cast<double>(state->patch.free_count);
  return run.seconds_per_vertex * vertices * (task.options.evolution ? 1 : share_of_initial_patch);
}

}  // namespace

FillOutcome fill_patches(const FillRun& run, RunRecorder& recorder, const Job& job) {
  FillOutcome outcome;
  std::set<int> begun;
  int done = 0;
  const int total = run.loops();
  const double all_work = run.work();
  double work_done = 0;
  for (const FillTask& task : run.tasks) {
    const auto begins = [&](const BoundaryLoop& loop) {
      return begun.insert(task.first_loop + loop.number - 1).second;
    };
    std::map<int, BoundaryLoop> wanted = task.wanted;
    std::erase_if(wanted, [&](const auto& entry) { return begun.contains(entry.first); });
    const auto& index = task.scan_context->index();  // takes a while where it is the first of the scan
    if (run.expects) run.expects(expected_seconds(run, task));
    TaskRecording recording(run, task, recorder, job, outcome);
    HolesToSolve holes{with_neighbors(task, wanted), {}, task.closed};
    for (const BoundaryLoop& loop : holes.loops) begins(loop);
    for (const auto& [state, loops] : task.moved) {
      if (!std::all_of(loops.begin(), loops.end(), begins)) continue;
      InitialPatch& moved = holes.moved.emplace_back();
      moved.patch = state->patch;
      moved.loops = loops;
      moved.origin = InitialPatch::Origin::evolved;
      recording.go_on_from(state);
    }
    FillOptions options = task.options;
    options.most_memory_mb = memory_left_mb({});
    int of_task = 0;
    std::map<int, double> work;  // by number; of holes that are solved together the first is named
    for (const BoundaryLoop& loop : holes.loops) work[loop.number] = work_of(loop);
    for (const InitialPatch& moved : holes.moved)
      for (const BoundaryLoop& loop : moved.loops) work[loop.number] = work_of(loop);
    solve_holes(
        index, holes, options, recording.observer(),
        [&](const FillProgress& progress) {
          work_done += (progress.loops_done - of_task) * work[progress.loop_number];
          of_task = progress.loops_done;
          if (run.progress)
            run.progress(std::min(done + of_task, total), total,
                         all_work > 0 ? std::min(work_done / all_work, 1.0) : 0);
        },
        job.pause_token());
    done += of_task;
  }
  return outcome;
}

}  // namespace loopmend
