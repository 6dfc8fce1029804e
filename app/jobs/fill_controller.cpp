// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/fill_controller.h"

#include "analysis/curvature_field.h"
#include "core/error.h"
#include "document/labels.h"
#include "document/message_words.h"
#include "document/run_curves.h"
#include "document/timeline.h"
#include "jobs/state_making.h"

#include <algorithm>

namespace loopmend {
namespace {

std::set<int> loops_of(const std::vector<OpenPatch>& patches) {
  std::set<int> loops;
  for (const OpenPatch& patch : patches) loops.insert(patch.loops.begin(), patch.loops.end());
  return loops;
}

}  // namespace

FillController::FillController(Document& document, UndoHistory& undo, QObject* parent)
    : QObject(parent),
      document_(document),
      undo_(undo) {}

FillController::~FillController() {
  if (job_) job_->cancel();
  if (preview_job_) preview_job_->cancel();
  if (curvature_job_) curvature_job_->cancel();
}

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

std::vector<FillTask> FillController::fill_tasks(const std::set<int>& loops, const FillChoice& choice) {
  std::map<int, FillTask> by_scan;
  for (int loop : loops) {
    if (document_.patch_of(loop) || !document_.present(loop)) continue;
    const int scan = document_.scan_of(loop);
    by_scan[scan].wanted.emplace(loop, document_.loop(loop));
  }
  std::vector<FillTask> tasks;
  for (auto& [scan, task] : by_scan) {
    task.scan = scan;
    task.scan_context = context_of(scan);
    task.options.initial.density = choice.density;
    task.options.islands = choice.islands;
    task.first_loop = document_.first_loop_of(scan);
    task.origin = document_.origin();
    for (const OpenPatch& patch : document_.patches()) {
      if (patch.scan != scan) continue;
      const bool may_change =
          patch.acceptance == Acceptance::pending && patch.state->recipe.start == PatchRecipe::Start::holes;
      for (int loop : patch.loops)
        if (may_change)
          task.filled.emplace(loop, document_.loop(loop));
        else
          task.taken.insert(loop);
    }
    tasks.push_back(std::move(task));
  }
  return tasks;
}

void FillController::fill(const std::set<int>& loops, const FillChoice& choice) {
  start_fill(loops, choice, std::nullopt);
}

void FillController::fill_and_smooth(const std::set<int>& loops, const std::set<int>& patch_ids,
                                     const FillChoice& choice, const EvolutionOptions& options) {
  loops.empty() ? evolve(patch_ids, options, Pace::steady) : start_fill(loops, choice, Smoothing{patch_ids, options});
}

void FillController::start_fill(const std::set<int>& loops, const FillChoice& choice,
                                const std::optional<Smoothing>& then) {
  if (busy()) return;
  const std::vector<FillTask> tasks = fill_tasks(loops, choice);
  std::set<int> wanted;
  for (const FillTask& task : tasks)
    for (const auto& [loop, geometry] : task.wanted) wanted.insert(loop);
  if (wanted.empty()) return;
  const auto ready = preview_;
  const JobPtr job = begin(Activity::filling, tr("Filling %1").arg(labels::holes(document_, wanted)));
  if (ready && ready->loops == wanted && ready->choice == choice) {
    on_filled(ready->result, wanted, then);
    return;
  }
  const int total = static_cast<int>(wanted.size());
  tasks_.run(
      job,
      [this, job, tasks, total] {
        return make_initial_patches(
            tasks, [&](int done) { job->post([this, done, total] { Q_EMIT progress_changed(done, total); }); },
            job->token());
      },
      [this, wanted, then](FillResult result) { on_filled(std::move(result), wanted, then); },
      [this](const QString& text) { give_up(text); });
}

void FillController::preview_fill(const std::set<int>& loops, const FillChoice& choice) {
  if (busy()) return;
  drop_fill_preview();
  const std::vector<FillTask> tasks = fill_tasks(loops, choice);
  std::set<int> wanted;
  for (const FillTask& task : tasks)
    for (const auto& [loop, geometry] : task.wanted) wanted.insert(loop);
  if (wanted.empty()) return;
  preview_job_ = std::make_shared<Job>(this);
  const JobPtr job = preview_job_;
  tasks_.run(
      job,
      [job, tasks] {
        return make_initial_patches(
            tasks, [](int) {}, job->token());
      },
      [this, wanted, choice](FillResult result) {
        std::vector<std::shared_ptr<const SurfaceShape>> ghosts;
        for (const OpenPatch& patch : result.patches) ghosts.push_back(patch.state->shape);
        preview_ = std::make_shared<FillPreview>(FillPreview{wanted, choice, std::move(result)});
        Q_EMIT ghosts_changed(ghosts);
      },
      [](const QString&) {});  // Fill will say it in words
}

void FillController::drop_fill_preview() {
  if (preview_job_) preview_job_->cancel();
  preview_job_.reset();
  if (!std::exchange(preview_, nullptr)) return;
  Q_EMIT ghosts_changed({});
}

void FillController::on_filled(FillResult result, const std::set<int>& wanted, const std::optional<Smoothing>& then) {
  const qint64 milliseconds = clock_.elapsed();
  end();
  std::vector<PatchChange::Pair> pairs;
  std::set<int> refilled;
  std::size_t triangles = 0;
  for (OpenPatch& patch : result.patches) {
    for (int loop : patch.loops)
      if (const OpenPatch* old = document_.patch_of(loop); old && refilled.insert(old->id).second)
        pairs.push_back({*old, std::nullopt});
    patch.id = document_.next_patch_id();
    triangles += static_cast<std::size_t>(patch.state->patch.patch_triangles);
    pairs.push_back({std::nullopt, patch});
  }
  document_.forget_failures(wanted);
  document_.add_failures(result.failures);
  const std::set<int> done = loops_of(result.patches);
  if (!done.empty()) {
    const QString name = labels::holes(document_, done);
    push(std::move(pairs), tr("Fill %1").arg(name), then ? then->joining : PatchChange::Joining::none);
    Q_EMIT logged(
        tr("Filled %1 with %2 triangles in %3 s.").arg(name, labels::count(triangles), labels::seconds(milliseconds)));
  }
  if (!refilled.empty())
    Q_EMIT logged(tr("Some of these holes lie so close to filled ones that both were filled anew, as one."));
  say_fill_outcome(result, wanted);
  if (!done.empty()) Q_EMIT filled(done);
  if (!then) return;
  std::set<int> to_smooth = then->patch_ids;
  for (int loop : done)
    if (const OpenPatch* patch = document_.patch_of(loop)) to_smooth.insert(patch->id);
  start_flow(to_smooth, then->options, Pace::steady,
             done.empty() ? PatchChange::Joining::none : PatchChange::Joining::previous);
}

void FillController::say_fill_outcome(const FillResult& result, const std::set<int>& wanted) {
  constexpr std::size_t most_lines = 20;
  std::size_t lines = 0;
  for (const auto& [loop, remark] : result.remarks)
    if (lines++ < most_lines)
      Q_EMIT logged(tr("Hole %1: %2").arg(labels::hole_name(document_, loop), labels::in_words(remark)));
  for (const auto& [loop, why] : result.failures)
    if (lines++ < 2 * most_lines)
      Q_EMIT logged(tr("Hole %1 stays open: %2").arg(labels::hole_name(document_, loop), labels::in_words(why)));
  if (!result.failures.empty())
    Q_EMIT failed(tr("%L1 of %L2 holes could not be filled. The State column says why, and what may help.")
                      .arg(result.failures.size())
                      .arg(wanted.size()));
}

void FillController::adopt(OpenPatch patch) {
  if (busy() || !document_.scan(patch.scan)) return;
  const JobPtr job = begin(Activity::filling, tr("Taking over %1").arg(labels::holes(document_, loops_of(patch))));
  tasks_.run(
      job,
      [patch, scan_context = context_of(patch.scan), origin = document_.origin()] {
        auto state = std::make_shared<PatchState>(*patch.state);
        state->shape = std::make_shared<SurfaceShape>(
            shape_of(state->patch, curvature_field(state->patch), origin, scan_context->colors()));
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
  Q_EMIT logged(run_words(patch, patch));
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

bool FillController::shut_down(std::chrono::milliseconds at_most) {
  if (job_) job_->cancel();
  if (preview_job_) preview_job_->cancel();
  cancel_curvature();
  return tasks_.wait(at_most);
}

}  // namespace loopmend
