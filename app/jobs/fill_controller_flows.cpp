// SPDX-License-Identifier: GPL-3.0-or-later
// The controller's runs of flows.
#include "core/error.h"
#include "document/labels.h"
#include "document/message_words.h"
#include "document/run_curves.h"
#include "document/targets.h"
#include "jobs/fill_controller.h"

#include <cmath>
#include <utility>

namespace loopmend {
void FillController::evolve(const std::set<int>& patch_ids, EvolutionOptions options, Pace pace) {
  if (is_to_steady_state(pace))
    start_fill({{}, {}, patch_ids, std::move(options), pace});
  else
    start_steps(patch_ids, std::move(options), pace);
}

JobPtr FillController::begin_run(Activity activity, const QString& stage, const std::set<int>& loops,
                                 PatchChange::Joining joining) {
  const JobPtr job = begin(activity, stage);
  run_.emplace(document_, timeline_budget_);
  run_loops_ = loops;
  announced_later_.clear();
  fill_loops_.clear();
  run_joining_ = joining;
  if (activity != Activity::filling) show_running();
  return job;
}

void FillController::start_steps(const std::set<int>& patch_ids, EvolutionOptions options, Pace pace) {
  if (busy()) return;
  StepTask task;
  task.options = std::move(options);
  task.options.mode = EvolutionMode::steps;
  task.pace = pace;
  task.origin = document_.origin();
  std::set<int> loops;
  for (int id : patch_ids) {
    const OpenPatch* patch = document_.patch(id);
    if (!patch || patch->acceptance == Acceptance::accepted) continue;
    const auto session = sessions_.find(id);
    const bool fits = session != sessions_.end() && session->second.state == patch->state;
    StepTask::Item item{*patch, fits ? session->second.evolution : nullptr, context_of(patch->scan), {}};
    for (int loop : patch->loops) item.loops.push_back(document_.loop(loop));
    task.items.push_back(std::move(item));
    loops.merge(loops_of(*patch));
    sessions_.erase(id);  // the worker has it now
  }
  if (task.items.empty()) return;
  const QString name = labels::flow_name(task.options.flow), where = labels::holes(document_, loops);
  run_name_ = pace == Pace::time_step ? tr("%1 step on %2").arg(name, where) : tr("%1 on %2").arg(name, where);
  const JobPtr job = begin_run(pace == Pace::time_step ? Activity::stepping : Activity::running, run_name_, loops,
                               PatchChange::Joining::none);
  recorder_ = std::make_shared<RunRecorder>([this, job] { job->post([this] { take_records(); }); });
  tasks_.run(
      job, [job, task = std::move(task), recorder = recorder_] { return step_patches(task, *recorder, *job); },
      [this](const StepResult& result) {
        sessions_ = result.sessions;
        on_run_ended({result.failures, {}});
      },
      [this](const QString& text) {
        on_run_ended({});
        report_failure(text);
      });
}

void FillController::show_running() {
  std::set<int> running;
  for (int loop : run_loops_)
    if (const OpenPatch* patch = document_.patch_of(loop)) running.insert(patch->id);
  document_.set_running(running);
}

void FillController::take_records() {
  if (!run_) return;
  if (recorder_) run_->place(recorder_->take());
  if (activity_ != Activity::filling) show_running();
  std::set<int> come;
  for (int loop : announced_later_)
    if (document_.patch_of(loop)) come.insert(loop);
  // The small ones are there first.
  if (come.empty() || !come.contains(largest(document_, announced_later_, 1).front())) return;
  announced_later_.clear();
  Q_EMIT filled(come);
}

/// Of those with the worst verdict, if there is anything to look at.
void FillController::announce_first_to_look_at(const std::set<int>& loops) {
  std::set<int> worst;
  int urgency = 0;
  for (int loop : loops) {
    if (!document_.present(loop) || !document_.to_look_at(loop)) continue;
    const int own = labels::urgency(document_.state(loop));
    if (worst.empty() || own < urgency) worst.clear();
    if (worst.empty() || own <= urgency) worst.insert(loop);
    if (worst.contains(loop)) urgency = own;
  }
  if (!worst.empty()) Q_EMIT filled(worst);
}

void FillController::on_run_ended(const FillOutcome& outcome) {
  const bool was_flow = activity_ != Activity::filling;
  const bool is_whole = outcome.failures.empty() && !job_->asked_to_pause();
  take_records();
  run_->place_rest();
  record_run();
  const std::set<int> fills = std::exchange(announced_later_, {}), all = std::exchange(fill_loops_, {});
  end();
  say_outcome(outcome);
  if (!fills.empty()) Q_EMIT filled(fills);
  announce_first_to_look_at(all);
  if (was_flow) Q_EMIT flow_ended(is_whole ? RunEnd::complete : RunEnd::stopped);
}

QString FillController::run_words(const PatchState* before, const OpenPatch& now) const {
  const PatchState& state = *now.state;
  QString line = tr("%1, %2: %3 steps")
                     .arg(labels::sentence(labels::holes(document_, loops_of(now))), labels::flow_name(state.flow))
                     .arg(state.steps - (before ? before->steps : 0));
  const RunCurves run(now);
  if (run.lowered.size() > 1)
    line += (run.split ? tr(", J %1 \u2192 %2") : tr(", energy %1 \u2192 %2"))
                .arg(labels::number(run.lowered.front()), labels::number(run.lowered.back()));
  line += tr(", %1 s.").arg(labels::seconds(std::llround(1000 * state.seconds.total)));
  if (!state.message.empty()) line += QLatin1Char(' ') + labels::sentence(labels::in_words(state.message));
  return line;
}

void FillController::log_run(const std::vector<PatchChange::Pair>& changes) {
  constexpr int most_lines = 40;
  const bool flows = activity_ != Activity::filling;
  int lines = 0;
  std::size_t triangles = 0;
  std::set<int> come, gone;
  for (const auto& [before, after] : changes) {
    if (!after) gone.merge(loops_of(*before));
    if (!after) continue;
    if (flows && lines++ < most_lines) Q_EMIT logged(run_words(before ? before->state.get() : nullptr, *after));
    triangles += static_cast<std::size_t>(after->state->patch.patch_triangles);
    come.merge(loops_of(*after));
  }
  if (lines > most_lines) Q_EMIT logged(tr("%Ln more", nullptr, lines - most_lines));
  if (flows && !gone.empty())
    Q_EMIT logged(tr("%1 ask for different smoothing: they are closed by other patches now.")
                      .arg(labels::sentence(labels::holes(document_, gone))));
  if (flows || come.empty()) return;
  Q_EMIT logged(tr("Filled %1 with %2 triangles in %3 s.")
                    .arg(labels::holes(document_, come), labels::count(triangles), labels::seconds(clock_.elapsed())));
  if (!gone.empty())
    Q_EMIT logged(tr("Some of these holes lie so close to filled ones that both were filled anew, as one."));
}

void FillController::record_run() {
  if (!run_) return;
  std::vector<PatchChange::Pair> changes = run_->changes();
  log_run(changes);
  run_.reset();
  recorder_.reset();
  push(std::move(changes), run_name_, run_joining_);
}

void FillController::pause() {
  if (!job_ || (activity_ != Activity::running && activity_ != Activity::solving)) return;
  job_->ask_to_pause();
  activity_ = Activity::pausing;
  Q_EMIT activity_changed();
  Q_EMIT stage_changed(tr("Pausing after this step"));
}

void FillController::cancel() {
  if (!job_) return;
  const Activity what = activity_;
  if (what != Activity::filling) take_records();
  if (what != Activity::filling && run_) run_->place_rest();
  job_->cancel();
  if (what == Activity::opening) drop_preview();
  record_run();
  end();
  const bool was_flow =
      what == Activity::running || what == Activity::solving || what == Activity::stepping || what == Activity::pausing;
  if (was_flow) Q_EMIT flow_ended(RunEnd::stopped);
  Q_EMIT logged(was_flow ? tr("Cancelled; the last accepted state is kept.") : tr("Cancelled."));
}

}  // namespace loopmend
