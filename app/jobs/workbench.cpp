#include "jobs/workbench.h"

#include "document/undo_commands.h"
#include "document/words.h"
#include "io/write_mesh.h"
#include "jobs/load_scan.h"

#include <QDir>
#include <QFileInfo>

namespace loopmend {
namespace {

QString seconds(qint64 milliseconds) { return QString::number(static_cast<double>(milliseconds) / 1000, 'f', 1); }

Activity activity_of(Pace pace) {
  switch (pace) {
    case Pace::one_step: return Activity::stepping;
    case Pace::run: return Activity::running;
    case Pace::steady: return Activity::solving;
  }
  return Activity::idle;
}

}  // namespace

Workbench::Workbench(Document& document, QUndoStack& undo, QObject* parent)
    : QObject(parent),
      document_(document),
      undo_(undo) {}

Workbench::~Workbench() {
  if (job_) job_->token().cancel();
}

JobPtr Workbench::begin(Activity activity, const QString& stage) {
  job_ = std::make_shared<Job>(this);
  activity_ = activity;
  clock_.start();
  Q_EMIT activity_changed();
  Q_EMIT stage_changed(stage);
  Q_EMIT progress_changed(0, 0);
  return job_;
}

void Workbench::end() {
  job_.reset();
  activity_ = Activity::idle;
  document_.set_running({});
  Q_EMIT stage_changed({});
  Q_EMIT activity_changed();
}

void Workbench::open(const QString& path) { load(path, tr("Opening %1").arg(QFileInfo(path).fileName())); }

void Workbench::open_sample() { load({}, tr("Making the sample")); }

void Workbench::load(const QString& path, const QString& stage) {
  if (busy()) cancel();
  const JobPtr job = begin(Activity::opening, stage);
  LoadStages stages;
  stages.stage = [this, job](const QString& words) { job->tell([this, words] { Q_EMIT stage_changed(words); }); };
  stages.picture = [this, job](auto shape) { job->tell([this, shape] { Q_EMIT preview_ready(shape); }); };
  stages.opened = [this, job](OpenedScan scan) {
    job->tell([this, scan = std::move(scan)]() mutable { on_opened(std::move(scan), clock_.elapsed()); });
  };
  stages.colored = [this, job](auto shape) { job->tell([this, shape] { document_.set_shape(shape); }); };
  tasks_.start([this, job, stages, path] {
    try {
      load_scan(path, stages, job->token());
      job->tell([this] { end(); });
    } catch (const std::exception& error) {
      job->tell([this, words = QString::fromUtf8(error.what())] { on_open_failed(words); });
    }
  });
}

void Workbench::on_opened(OpenedScan scan, qint64 milliseconds) {
  sessions_.clear();
  undo_.clear();
  document_.open(std::move(scan));
  Q_EMIT said(words::import_summary(document_.scan()) + tr(" Opened in %1 s.").arg(seconds(milliseconds)));
  if (document_.loops().empty()) Q_EMIT notice(tr("This surface is closed: there is no hole to fill."));
}

void Workbench::on_open_failed(const QString& words) {
  Q_EMIT preview_dropped();
  end();
  Q_EMIT failed(words);
  Q_EMIT said(words);
}

void Workbench::fill(const std::set<int>& loops, double density) {
  if (busy() || !document_.has_scan()) return;
  FillTask task;
  std::set<int> wanted;
  for (int loop : loops) {
    if (document_.patch_of(loop)) continue;
    wanted.insert(loop);
    task.loop_indices.push_back(loop);
    task.loops.push_back(document_.loops()[static_cast<std::size_t>(loop)]);
  }
  if (wanted.empty()) return;
  task.model = document_.scan().model;
  task.options.density = density;
  task.origin = document_.scan().origin;
  const JobPtr job = begin(Activity::filling, tr("Filling %1").arg(words::holes(document_, wanted)));
  const int total = static_cast<int>(wanted.size());
  tasks_.start([this, job, task = std::move(task), wanted, total] {
    const auto progress = [&](int done) { job->tell([this, done, total] { Q_EMIT progress_changed(done, total); }); };
    try {
      auto result = std::make_shared<FillResult>(fill_holes(task, progress, job->token()));
      job->tell([this, result, wanted] { on_filled(std::move(*result), wanted, clock_.elapsed()); });
    } catch (const std::exception& error) {
      job->tell([this, words = QString::fromUtf8(error.what())] {
        end();
        Q_EMIT failed(words);
      });
    }
  });
}

void Workbench::on_filled(FillResult result, const std::set<int>& wanted, qint64 milliseconds) {
  end();
  std::set<int> done;
  std::size_t triangles = 0;
  for (OpenPatch& patch : result.patches) {
    patch.id = document_.next_patch_id();
    done.insert(patch.loops.begin(), patch.loops.end());
    triangles += static_cast<std::size_t>(patch.state->patch.patch_triangles);
  }
  document_.set_failures(result.failures);
  if (!done.empty()) {
    const QString name = words::holes(document_, done);
    undo_.push(new FillCommand(document_, std::move(result.patches), tr("Fill %1").arg(name)));
    Q_EMIT said(tr("Filled %1 with %2 triangles in %3 s.").arg(name).arg(triangles).arg(seconds(milliseconds)));
  }
  for (const auto& [loop, words] : result.remarks)
    Q_EMIT said(tr("Hole %1: %2")
                    .arg(document_.loops()[static_cast<std::size_t>(loop)].number)
                    .arg(QString::fromStdString(words)));
  for (const auto& [loop, words] : result.failures)
    Q_EMIT said(tr("Hole %1 stays open: %2")
                    .arg(document_.loops()[static_cast<std::size_t>(loop)].number)
                    .arg(QString::fromStdString(words)));
  if (!result.failures.empty())
    Q_EMIT failed(tr("%1 of %2 holes could not be filled. The State column says why.")
                      .arg(result.failures.size())
                      .arg(wanted.size()));
}

void Workbench::evolve(const std::set<int>& patch_ids, FlowKind flow, double sigma, Pace pace) {
  if (busy() || patch_ids.empty()) return;
  EvolveTask task;
  task.options.flow = flow;
  task.options.sigma = sigma;
  task.options.mode = pace == Pace::steady ? EvolutionMode::steady : EvolutionMode::steps;
  task.pace = pace;
  task.origin = document_.scan().origin;
  run_start_.clear();
  std::set<int> loops;
  for (int id : patch_ids) {
    const OpenPatch* patch = document_.patch(id);
    if (!patch) continue;
    const auto session = sessions_.find(id);
    const bool fits = session != sessions_.end() && session->second.state == patch->state;
    task.items.push_back({id, patch->state, fits ? session->second.evolution : nullptr});
    run_start_[id] = patch->state;
    loops.insert(patch->loops.begin(), patch->loops.end());
    sessions_.erase(id);  // the worker has it now
  }
  if (task.items.empty()) return;
  const QString name = words::flow_name(flow), where = words::holes(document_, loops);
  run_name_ = pace == Pace::one_step ? tr("%1 step on %2").arg(name, where) : tr("%1 on %2").arg(name, where);
  const JobPtr job = begin(activity_of(pace), run_name_);
  document_.set_running(patch_ids);
  mailbox_ = std::make_shared<SnapshotMailbox>([this, job] { job->tell([this] { take_snapshots(); }); });
  tasks_.start([this, job, task = std::move(task), mailbox = mailbox_] {
    const auto show = [&](int id, PatchStatePtr state) { mailbox->put(id, std::move(state)); };
    try {
      auto result = std::make_shared<EvolveResult>(evolve_patches(task, show, *job));
      job->tell([this, result] { on_evolved(*result); });
    } catch (const std::exception& error) {
      job->tell([this, words = QString::fromUtf8(error.what())] {
        on_evolved({});
        Q_EMIT failed(words);
      });
    }
  });
}

void Workbench::take_snapshots() {
  if (!mailbox_) return;
  document_.set_states(mailbox_->take());
}

void Workbench::on_evolved(const EvolveResult& result) {
  take_snapshots();
  sessions_.clear();
  for (const auto& [id, session] : result.sessions) sessions_[id] = session;
  record_run();
  end();
  for (const auto& [id, words] : result.failures) Q_EMIT failed(QString::fromStdString(words));
}

void Workbench::record_run() {
  std::vector<EvolveCommand::Change> changes;
  for (const auto& [id, before] : run_start_) {
    const OpenPatch* patch = document_.patch(id);
    if (!patch || patch->state == before) continue;
    changes.push_back({id, before, patch->state});
    const PatchState& now = *patch->state;
    const std::set<int> loops(patch->loops.begin(), patch->loops.end());
    QString line = tr("%1, %2: %3 steps, energy %4 \u2192 %5, %6 s.")
                       .arg(words::holes(document_, loops), words::flow_name(now.flow))
                       .arg(now.steps - before->steps)
                       .arg(words::number(now.initial_energy), words::number(now.steps > 0 ? now.last_step.energy : 0))
                       .arg(now.seconds, 0, 'f', 1);
    line[0] = line[0].toUpper();
    if (!now.message.empty()) line += QLatin1Char(' ') + QString::fromStdString(now.message);
    Q_EMIT said(line);
  }
  run_start_.clear();
  mailbox_.reset();
  if (!changes.empty()) undo_.push(new EvolveCommand(document_, std::move(changes), run_name_));
}

void Workbench::pause() {
  if (!job_ || (activity_ != Activity::running && activity_ != Activity::solving)) return;
  job_->ask_to_pause();
  activity_ = Activity::pausing;
  Q_EMIT activity_changed();
  Q_EMIT stage_changed(tr("Pausing after this step"));
}

void Workbench::cancel() {
  if (!job_) return;
  take_snapshots();
  const Activity what = activity_;
  job_->token().cancel();
  if (what == Activity::opening) Q_EMIT preview_dropped();
  record_run();
  end();
  Q_EMIT said(what == Activity::running || what == Activity::solving || what == Activity::stepping ||
                      what == Activity::pausing
                  ? tr("Cancelled; the last accepted state is kept.")
                  : tr("Cancelled."));
}

void Workbench::export_to(const QString& path) {
  if (busy() || !document_.has_scan()) return;
  std::vector<PatchStatePtr> states;
  for (const OpenPatch& patch : document_.patches()) states.push_back(patch.state);
  const auto scan = document_.scan().model;
  const JobPtr job = begin(Activity::exporting, tr("Writing %1").arg(QFileInfo(path).fileName()));
  tasks_.start([this, job, scan, states, path] {
    try {
      SurfaceModel model = *scan;
      for (const PatchStatePtr& state : states) {
        if (job->token().cancelled()) return;
        append_patch(model, patch_geometry(state->patch));
      }
      if (job->token().cancelled()) return;
      write_mesh(path.toStdString(), model.soup);
      job->tell([this, path, count = model.soup.triangles.size()] {
        end();
        const QString words = tr("Wrote %1: %2 triangles.").arg(QDir::toNativeSeparators(path)).arg(count);
        Q_EMIT said(words);
        Q_EMIT notice(words);
      });
    } catch (const std::exception& error) {
      job->tell([this, words = QString::fromUtf8(error.what())] {
        end();
        Q_EMIT failed(words);
        Q_EMIT said(words);
      });
    }
  });
}

bool Workbench::shut_down(std::chrono::milliseconds at_most) {
  if (job_) job_->token().cancel();
  return tasks_.wait(at_most);
}

}  // namespace loopmend
