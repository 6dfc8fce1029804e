// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/fill_controller.h"

#include "core/error.h"
#include "document/labels.h"
#include "document/message_words.h"
#include "jobs/remaining_time.h"
#include "jobs/state_making.h"

#include <QTimer>

#include <algorithm>
#include <tuple>

namespace loopmend {

FillController::FillController(Document& document, UndoHistory& undo, QObject* parent)
    : QObject(parent),
      document_(document),
      undo_(undo),
      seconds_per_vertex_(seconds_of_a_vertex) {}

JobPtr FillController::begin(Activity activity, const QString& stage) {
  drop_fill_preview();
  job_ = std::make_shared<Job>(this);
  activity_ = activity;
  clock_.start();
  Q_EMIT activity_changed();
  Q_EMIT stage_changed(stage);
  Q_EMIT progress_changed(0, 0);
  return job_;
}

void FillController::end() {
  job_.reset();
  activity_ = Activity::idle;
  document_.set_running({});
  Q_EMIT stage_changed(computing_curvature() ? tr("Computing curvature") : QString());
  Q_EMIT activity_changed();
}

void FillController::give_up(const QString& text) {
  end();
  report_failure(text);
}

void FillController::report_failure(const QString& words) {
  Q_EMIT failed(words);
  Q_EMIT logged(words);
}

ScanContextPtr FillController::context_of(int scan) {
  ScanContextPtr& scan_context = scan_contexts_[scan];
  if (!scan_context)
    scan_context = std::make_shared<ScanContext>(document_.scan(scan)->model, document_.scan(scan)->colors);
  return scan_context;
}

void FillController::push(std::vector<PatchChange::Pair> pairs, const QString& text, PatchChange::Joining joining) {
  if (!pairs.empty()) undo_.push(std::make_unique<PatchChange>(document_, std::move(pairs), text, joining));
}

void FillController::fill(const std::set<int>& loops, const FillChoice& choice) { start_fill({loops, choice}); }

void FillController::fill_and_smooth(const std::set<int>& loops, const std::set<int>& patch_ids,
                                     const FillChoice& choice, const EvolutionOptions& options) {
  start_fill({loops, choice, patch_ids, options});
}

void FillController::add_other_patches(int scan, FillTask& task) const {
  const bool is_new = std::none_of(task.wanted.begin(), task.wanted.end(),
                                   [this](const auto& entry) { return document_.patch_of(entry.first); });
  for (const OpenPatch& patch : document_.patches()) {
    if (patch.scan != scan || task.wanted.contains(patch.loops.front())) continue;
    const bool is_alike = !task.wanted.empty() && document_.chosen_shape(patch.loops.front()) ==
                                                      document_.chosen_shape(task.wanted.begin()->first);
    const bool may_change = is_new && is_alike && patch.acceptance == Acceptance::pending &&
                            patch.state->recipe.start == PatchRecipe::Start::holes;
    for (int loop : patch.loops)
      if (may_change)
        task.filled.emplace(loop, document_.loop(loop));
      else
        task.closed.insert(document_.loop(loop).number);
  }
}

/// Whether a patch is what this flow makes already, so that it stays as it is.
bool FillController::is_done(const OpenPatch& patch, const EvolutionOptions& asked) const {
  const std::vector<RunRecipe>& runs = patch.state->recipe.runs;
  if (runs.size() != 1 || runs.back().end != RunRecipe::End::whole || !is_at_end(patch.state->status)) return false;
  if (starts_anew(patch, asked)) return false;
  EvolutionOptions flow = flow_at(patch.loops.front(), asked);
  flow.mode = EvolutionMode::steady;
  flow.edge_edits = document_.edge_edits(patch.scan);
  RunRecipe wanted = recipe_of(flow);
  if (const auto plane = document_.mirror_plane(patch.scan)) {
    wanted.mirror = RunRecipe::Mirror::placed;
    wanted.mirror_plane = *plane;
  }
  wanted.steps = runs.back().steps;
  wanted.end = runs.back().end;
  return wanted == runs.back();
}

EvolutionOptions FillController::flow_at(int loop, EvolutionOptions flow) const {
  if (const auto shape = document_.chosen_shape(loop)) {
    flow.flow = FlowKind::mmcvf;
    flow.continuity = *shape;
  }
  return flow;
}

bool FillController::starts_anew(const OpenPatch& patch, const std::optional<EvolutionOptions>& flow) const {
  const std::vector<RunRecipe>& runs = patch.state->recipe.runs;
  if (runs.empty()) return true;
  return flow && std::any_of(patch.loops.begin(), patch.loops.end(), [&](int loop) {
           const EvolutionOptions wanted = flow_at(loop, *flow);
           return wanted.flow == FlowKind::mmcvf && wanted.continuity != runs.back().continuity;
         });
}

FillRun FillController::fill_run(FillRequest& request) {
  std::erase_if(request.loops, [this](int loop) { return document_.patch_of(loop) || !document_.present(loop); });
  std::erase_if(request.patch_ids, [this, &flow = request.flow](int id) {
    const OpenPatch* patch = document_.patch(id);
    return !patch || patch->acceptance == Acceptance::accepted || (flow && is_done(*patch, *flow));
  });
  FillOptions options;
  options.evolution = request.flow;
  if (options.evolution) options.evolution->mode = EvolutionMode::steady;
  using Shape = std::optional<SeamContinuity>;
  std::map<std::pair<int, Shape>, FillTask> new_loops;                             // by scan and shape
  std::map<std::tuple<int, Shape, double, FillOptions::Islands>, FillTask> again;  // and options
  const auto prepare = [&](FillTask& task, int loop, double density, FillOptions::Islands islands) -> FillTask& {
    const int scan = document_.scan_of(loop);
    task.scan_context = context_of(scan);
    task.first_loop = document_.first_loop_of(scan);
    task.options = options;
    if (task.options.evolution) {
      task.options.evolution = flow_at(loop, *options.evolution);
      task.options.evolution->edge_edits = document_.edge_edits(scan);
      if (const auto plane = document_.mirror_plane(scan)) task.options.mirror_planes = {*plane};
    }
    task.options.initial.density = density;
    task.options.islands = islands;
    return task;
  };
  for (int loop : request.loops) {
    prepare(new_loops[{document_.scan_of(loop), document_.chosen_shape(loop)}], loop, request.choice.density,
            request.choice.islands)
        .wanted.emplace(loop, document_.loop(loop));
  }
  for (int id : request.patch_ids) {
    const OpenPatch& patch = *document_.patch(id);
    const PatchRecipe& recipe = patch.state->recipe;
    const auto islands =
        recipe.start == PatchRecipe::Start::bridge ? FillOptions::Islands::join : FillOptions::Islands::cover;
    const auto task_of = [&](int loop) -> FillTask& {
      return prepare(again[{patch.scan, document_.chosen_shape(loop), recipe.density, islands}], loop, recipe.density,
                     islands);
    };
    if (starts_anew(patch, request.flow)) {
      for (int loop : patch.loops) task_of(loop).wanted.emplace(loop, document_.loop(loop));
      continue;
    }
    std::vector<BoundaryLoop> loops;
    for (int loop : patch.loops) loops.push_back(document_.loop(loop));
    task_of(patch.loops.front()).moved.emplace_back(patch.state, std::move(loops));
  }
  FillRun run;
  run.pace = request.pace;
  run.patches = static_cast<int>(request.patch_ids.size());
  run.origin = document_.origin();
  for (auto& [key, task] : new_loops) {
    add_other_patches(key.first, task);
    run.tasks.push_back(std::move(task));
  }
  for (auto& [key, task] : again) {
    add_other_patches(std::get<int>(key), task);
    run.tasks.push_back(std::move(task));
  }
  return run;
}

void FillController::start_fill(FillRequest request) {
  if (busy()) return;
  const bool had_patches = !request.patch_ids.empty();
  FillRun run = fill_run(request);
  const int total = run.loops();
  if (total == 0) {
    if (had_patches && request.flow)
      Q_EMIT notice(
          tr("These patches are at the end of this flow already. Other options change them, Run steps goes on."));
    return;
  }
  std::set<int> loops = request.loops;
  for (int id : request.patch_ids) loops.merge(loops_of(*document_.patch(id)));
  const QString where = labels::holes(document_, loops);
  const auto ready = preview_;
  const bool flows = request.flow.has_value();
  run_name_ = !flows                  ? tr("Fill %1").arg(where)
              : request.loops.empty() ? tr("%1 on %2").arg(labels::flow_name(request.flow->flow), where)
                                      : tr("Fill and smooth %1").arg(where);
  const Activity activity = !flows                          ? Activity::filling
                            : request.pace == Pace::watched ? Activity::running
                                                            : Activity::solving;
  const JobPtr job = begin_run(activity, flows ? run_name_ : tr("Filling %1").arg(where), loops, request.joining);
  announced_later_ = fill_loops_ = request.loops;
  if (flows) sessions_.clear();
  if (!flows && ready && ready->loops == loops && ready->choice == request.choice) {
    run_->place(ready->runs);
    on_run_ended(ready->outcome);
    return;
  }
  if (total > 1)
    run.progress = [this, job](int done, int all, double share) {
      job->post([this, done, all, share] {
        Q_EMIT progress_changed(done, all);
        Q_EMIT share_done(share);
      });
    };
  const bool is_timed = total == 1 && request.pace == Pace::steady;
  if (is_timed) {
    run.seconds_per_vertex = seconds_per_vertex_;
    run.expects = [this, job](double seconds) { job->post([this, seconds] { Q_EMIT seconds_left(seconds); }); };
  }
  std::function<void()> wake;  // where no flow follows, all appear at once
  if (flows)
    wake = [this, job, wait = total > most_live ? 1000 : 0] {
      job->post([this, job, wait] {
        QTimer::singleShot(wait, this, [this, job] {
          if (job == job_) take_records();
        });
      });
    };
  recorder_ = std::make_shared<RunRecorder>(std::move(wake));
  tasks_.run(
      job, [job, run = std::move(run), recorder = recorder_] { return fill_patches(run, *recorder, *job); },
      [this, job, timed = is_timed && flows ? loops : std::set<int>()](const FillOutcome& outcome) {
        const double seconds = static_cast<double>(clock_.elapsed()) / 1000;
        on_run_ended(outcome);
        if (!job->asked_to_pause()) note_time(timed, seconds);
      },
      [this](const QString& text) {
        on_run_ended({});
        report_failure(text);
      });
}

/// The next estimate is made of it.
void FillController::note_time(const std::set<int>& loops, double seconds) {
  constexpr int least_vertices = 2000;  // the time of a smaller patch says little on the rest
  for (int loop : loops)
    if (const OpenPatch* patch = document_.patch_of(loop); patch && patch->state->patch.free_count >= least_vertices)
      seconds_per_vertex_ = seconds / patch->state->patch.free_count;
}

void FillController::preview_fill(const std::set<int>& loops, const FillChoice& choice) {
  if (busy()) return;
  drop_fill_preview();
  FillRequest request{loops, choice};
  FillRun run = fill_run(request);
  if (run.loops() == 0) return;
  preview_job_ = std::make_shared<Job>(this);
  const JobPtr job = preview_job_;
  const auto recorder = std::make_shared<RunRecorder>(nullptr);
  tasks_.run(
      job, [job, run = std::move(run), recorder] { return fill_patches(run, *recorder, *job); },
      [this, request, recorder](const FillOutcome& outcome) {
        preview_ = std::make_shared<FillPreview>(FillPreview{request.loops, request.choice, recorder->take(), outcome});
        std::vector<SurfaceShapePtr> ghosts;
        for (const auto& [where, run_there] : preview_->runs) ghosts.push_back(run_there.steps.back()->shape);
        Q_EMIT ghosts_changed(ghosts);
      },
      [](const QString&) {});  // Fill will say it in words
}

void FillController::drop_fill_preview() {
  drop(preview_job_);
  if (!std::exchange(preview_, nullptr)) return;
  Q_EMIT ghosts_changed({});
}

void FillController::say_outcome(const FillOutcome& outcome) {
  constexpr std::size_t most_lines = 20;
  std::size_t lines = 0;
  for (const auto& [loop, remark] : outcome.remarks)
    if (lines++ < most_lines)
      Q_EMIT logged(tr("Hole %1: %2").arg(labels::hole_name(document_, loop), labels::in_words(remark)));
  std::set<QString> of_patches;
  std::map<int, Message> open;
  for (const auto& [loop, why] : outcome.failures)
    if (document_.patch_of(loop))
      of_patches.insert(labels::in_words(why));
    else
      open.emplace(loop, why);
  for (const QString& words : of_patches) report_failure(words);
  document_.forget_failures(run_loops_);
  document_.add_failures(open);
  for (const auto& [loop, why] : open)
    if (lines++ < 2 * most_lines)
      Q_EMIT logged(tr("Hole %1 stays open: %2").arg(labels::hole_name(document_, loop), labels::in_words(why)));
  if (open.size() == 1)
    Q_EMIT left_open(
        tr("Hole %1 could not be filled: %2. Point at its state in the table to see what may help.")
            .arg(labels::hole_name(document_, open.begin()->first), labels::in_words(open.begin()->second)));
  else if (!open.empty())
    Q_EMIT left_open(
        tr("%L1 of %L2 holes could not be filled. Point at the state of one in the table to see why, and what "
           "may help.")
            .arg(open.size())
            .arg(run_loops_.size()));
}

void FillController::adopt(OpenPatch patch) {
  if (busy() || !document_.scan(patch.scan)) return;
  const JobPtr job = begin(Activity::filling, tr("Taking over %1").arg(labels::holes(document_, loops_of(patch))));
  tasks_.run(
      job,
      [patch, scan_context = context_of(patch.scan), origin = document_.origin()] {
        auto state = std::make_shared<PatchState>(*patch.state);
        state->shape = shape_of(state->patch, origin, scan_context->colors());
        show_deviation(*state);
        return judged(std::move(state), &patch.timeline->front()->patch, *scan_context);
      },
      [this, patch](const PatchStatePtr& state) { on_judged(patch, state); },
      [this](const QString& text) { give_up(text); });
}

void FillController::on_judged(OpenPatch patch, PatchStatePtr state) {
  end();
  patch.timeline = std::make_shared<Timeline>(Timeline{patch.timeline->front(), state});
  patch.state = std::move(state);
  patch.id = document_.next_patch_id();
  std::vector<PatchChange::Pair> pairs;
  std::set<int> replaced;
  for (int loop : patch.loops)
    if (const OpenPatch* old = document_.patch_of(loop); old && replaced.insert(old->id).second)
      pairs.push_back({*old, std::nullopt});
  const QString what =
      tr("%1 on %2").arg(labels::flow_name(patch.state->flow), labels::holes(document_, loops_of(patch)));
  document_.forget_failures(loops_of(patch));
  Q_EMIT logged(run_words(nullptr, patch));
  pairs.push_back({std::nullopt, std::move(patch)});
  push(std::move(pairs), what);
}

void FillController::set_acceptance(const std::set<int>& patch_ids, Acceptance acceptance) {
  if (busy()) return;
  std::vector<PatchChange::Pair> pairs;
  std::set<int> loops;
  for (int id : patch_ids) {
    const OpenPatch* patch = document_.patch(id);
    if (!patch || patch->acceptance == acceptance) continue;
    OpenPatch after = *patch;
    after.acceptance = acceptance;
    loops.insert(patch->loops.begin(), patch->loops.end());
    pairs.push_back({*patch, std::move(after)});
  }
  const QString where = labels::holes(document_, loops);
  push(std::move(pairs),
       acceptance == Acceptance::accepted ? tr("Accept %1").arg(where) : tr("Open again: %1").arg(where));
}

void FillController::reject(const std::set<int>& patch_ids) {
  if (busy()) return;
  std::vector<PatchChange::Pair> pairs;
  std::set<int> loops;
  for (int id : patch_ids) {
    const OpenPatch* patch = document_.patch(id);
    if (!patch) continue;
    loops.insert(patch->loops.begin(), patch->loops.end());
    pairs.push_back({*patch, std::nullopt});
  }
  push(std::move(pairs), tr("Discard %1").arg(labels::holes(document_, loops)));
}

void FillController::scrub_to(const std::set<int>& patch_ids, std::size_t place) {
  if (busy()) return;
  std::map<int, PatchStatePtr> states;
  for (int id : patch_ids) {
    const OpenPatch* patch = document_.patch(id);
    if (!patch || patch->acceptance == Acceptance::accepted) continue;
    scrub_start_.emplace(id, *patch);
    states[id] = (*patch->timeline)[std::min(place, patch->timeline->size() - 1)];
  }
  document_.set_states(states);
}

void FillController::end_scrub() {
  std::vector<PatchChange::Pair> pairs;
  std::set<int> loops;
  for (const auto& [id, before] : std::exchange(scrub_start_, {})) {
    const OpenPatch* now = document_.patch(id);
    if (!now || now->state == before.state) continue;
    loops.insert(now->loops.begin(), now->loops.end());
    pairs.push_back({before, *now});
  }
  push(std::move(pairs), tr("Go back on %1").arg(labels::holes(document_, loops)));
}

bool FillController::shut_down(std::chrono::milliseconds at_most) { return tasks_.stop(at_most); }

}  // namespace loopmend
