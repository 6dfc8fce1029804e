// SPDX-License-Identifier: GPL-3.0-or-later
// The controller's runs of flows.
#include "core/error.h"
#include "document/labels.h"
#include "document/message_words.h"
#include "document/run_curves.h"
#include "document/timeline.h"
#include "jobs/fill_controller.h"

#include <algorithm>

namespace loopmend {
namespace {

Activity activity_of(Pace pace) {
  switch (pace) {
    case Pace::time_step: return Activity::stepping;
    case Pace::time_steps:
    case Pace::watched: return Activity::running;
    case Pace::steady: return Activity::solving;
  }
  return Activity::idle;
}

}  // namespace

void FillController::evolve(const std::set<int>& patch_ids, EvolutionOptions options, Pace pace) {
  start_flow(patch_ids, std::move(options), pace, PatchChange::Joining::none);
}

void FillController::start_flow(const std::set<int>& patch_ids, EvolutionOptions options, Pace pace,
                                PatchChange::Joining joining) {
  if (busy()) return;
  EvolveTask task;
  task.options = std::move(options);
  task.options.mode = is_to_steady_state(pace) ? EvolutionMode::steady : EvolutionMode::steps;
  task.pace = pace;
  task.origin = document_.origin();
  run_start_.clear();
  std::set<int> loops;
  for (int id : patch_ids) {
    const OpenPatch* patch = document_.patch(id);
    if (!patch || patch->acceptance == Acceptance::accepted) continue;
    const auto session = sessions_.find(id);
    const bool fits = session != sessions_.end() && session->second.state == patch->state;
    EvolveTask::Item item{*patch, fits ? session->second.evolution : nullptr, context_of(patch->scan), {}, {}, {}};
    for (int loop : patch->loops) {
      item.loops.push_back(document_.loop(loop));
      item.spare_ids.push_back(document_.next_patch_id());
    }
    task.items.push_back(std::move(item));
    run_start_.emplace(id, *patch);
    loops.insert(patch->loops.begin(), patch->loops.end());
    sessions_.erase(id);  // the worker has it now
  }
  if (task.items.empty()) return;
  const QString name = labels::flow_name(task.options.flow), where = labels::holes(document_, loops);
  run_name_ = pace == Pace::time_step ? tr("%1 step on %2").arg(name, where) : tr("%1 on %2").arg(name, where);
  const JobPtr job = begin(activity_of(pace), run_name_);
  run_joining_ = joining;
  if (joining == PatchChange::Joining::previous) run_name_ = tr("Fill and smooth %1").arg(where);
  if (const int total = static_cast<int>(task.items.size()); total > 1 && is_to_steady_state(pace))
    task.progress = [this, job, total](int done) {
      job->post([this, done, total] { Q_EMIT progress_changed(done, total); });
    };
  std::set<int> running;
  for (const auto& [id, patch] : run_start_) running.insert(id);
  document_.set_running(running);
  recorder_ = std::make_shared<RunRecorder>([this, job] { job->post([this] { take_records(); }); });
  tasks_.run(
      job, [job, task = std::move(task), recorder = recorder_] { return evolve_patches(task, *recorder, *job); },
      [this](const EvolveResult& result) {
        on_evolved(result, result.failures.empty() ? RunEnd::complete : RunEnd::stopped);
      },
      [this](const QString& text) {
        on_evolved({}, RunEnd::stopped);
        report_failure(text);
      });
}

void FillController::take_records() {
  if (!recorder_) return;
  const RunRecorder::News news = recorder_->take();
  for (const auto& [id, parts] : news.divisions) divide(id, parts);
  std::map<int, PatchStatePtr> newest;
  for (const auto& [id, run] : news.states) {
    const auto start = run_start_.find(id);
    if (run.empty() || start == run_start_.end()) continue;
    newest[id] = run.back();
    document_.set_timeline(id, extended(*start->second.timeline, start->second.state, run, timeline_budget_));
  }
  document_.set_states(newest);
}

void FillController::divide(int patch_id, const std::vector<OpenPatch>& parts) {
  const auto whole = run_start_.extract(patch_id);
  if (!whole) return;
  Division division{whole.mapped(), {}};
  for (const OpenPatch& part : parts) {
    division.parts.insert(part.id);
    run_start_.emplace(part.id, part);
  }
  Q_EMIT logged(tr("%1 ask for different smoothing, so that they become %2 patches.")
                    .arg(labels::sentence(labels::holes(document_, loops_of(division.whole))))
                    .arg(parts.size()));
  divisions_.push_back(std::move(division));
  document_.replace({patch_id}, parts);
  std::set<int> running;
  for (const auto& [id, patch] : run_start_) running.insert(id);
  document_.set_running(running);
}

void FillController::take_back_divisions(const EvolveResult& result) {
  std::erase_if(divisions_, [&](const Division& division) {
    const auto untouched = [&](int id) {
      return !result.splits.contains(id) && document_.patch(id)->state == run_start_.at(id).state;
    };
    if (!std::all_of(division.parts.begin(), division.parts.end(), untouched)) return false;
    for (int id : division.parts) run_start_.erase(id);
    document_.replace({division.parts.begin(), division.parts.end()}, {division.whole});
    return true;
  });
}

void FillController::on_evolved(const EvolveResult& result, RunEnd how) {
  take_records();
  sessions_ = result.sessions;
  record_run(result);
  if (job_ && job_->asked_to_pause()) how = RunEnd::stopped;
  end();
  Q_EMIT flow_ended(how);
  for (const auto& [id, why] : result.failures) report_failure(labels::in_words(why));
}

QString FillController::run_words(const OpenPatch& before, const OpenPatch& now) const {
  const PatchState& state = *now.state;
  QString line = tr("%1, %2: %3 steps")
                     .arg(labels::sentence(labels::holes(document_, loops_of(now))), labels::flow_name(state.flow))
                     .arg(state.steps - before.state->steps);
  const RunCurves run(now);
  if (run.lowered.size() > 1)
    line += (run.split ? tr(", J %1 \u2192 %2") : tr(", energy %1 \u2192 %2"))
                .arg(labels::number(run.lowered.front()), labels::number(run.lowered.back()));
  line += tr(", %1 s.").arg(labels::seconds(std::llround(1000 * state.seconds.total)));
  if (!state.message.empty()) line += QLatin1Char(' ') + labels::sentence(labels::in_words(state.message));
  return line;
}

void FillController::record_run(const EvolveResult& result) {
  constexpr int most_lines = 40;
  int lines = 0;
  const auto log_run = [&](const OpenPatch& before, const OpenPatch& now) {
    if (lines++ < most_lines) Q_EMIT logged(run_words(before, now));
  };
  take_back_divisions(result);
  std::vector<PatchChange::Pair> pairs;
  std::set<int> parts;  // which the document before the run does not have
  for (const Division& division : std::exchange(divisions_, {})) {
    pairs.push_back({division.whole, std::nullopt});
    parts.insert(division.parts.begin(), division.parts.end());
  }
  for (const auto& [id, before] : run_start_) {
    const OpenPatch* now = document_.patch(id);
    if (!now) continue;
    const auto known = parts.contains(id) ? std::nullopt : std::optional(before);
    if (const auto split = result.splits.find(id); split != result.splits.end()) {
      if (known)
        pairs.push_back({known, std::nullopt});
      else
        document_.replace({id}, {});
      for (OpenPatch part : split->second) {
        part.id = document_.next_patch_id();
        log_run(part, part);
        pairs.push_back({std::nullopt, std::move(part)});
      }
      Q_EMIT logged(tr("%1 could not be solved together; each was solved by itself.")
                        .arg(labels::sentence(labels::holes(document_, loops_of(before)))));
      continue;
    }
    const bool moved = now->state != before.state;
    if (moved) log_run(before, *now);
    if (moved || !known) pairs.push_back({known, *now});
  }
  if (lines > most_lines) Q_EMIT logged(tr("%Ln more", nullptr, lines - most_lines));
  run_start_.clear();
  recorder_.reset();
  push(std::move(pairs), run_name_, run_joining_);
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
  take_records();
  const Activity what = activity_;
  job_->cancel();
  if (what == Activity::opening) Q_EMIT preview_dropped();
  record_run({});
  end();
  const bool was_flow =
      what == Activity::running || what == Activity::solving || what == Activity::stepping || what == Activity::pausing;
  if (was_flow) Q_EMIT flow_ended(RunEnd::stopped);
  Q_EMIT logged(was_flow ? tr("Cancelled; the last accepted state is kept.") : tr("Cancelled."));
}

}  // namespace loopmend
