// SPDX-License-Identifier: GPL-3.0-or-later
// The controller's dealings with files: scans, sessions, exports.
#include "document/file_path.h"
#include "document/labels.h"
#include "document/message_words.h"
#include "document/timeline.h"
#include "jobs/fill_controller.h"
#include "jobs/state_making.h"

#include "core/error.h"

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>

#include <algorithm>
#include <utility>

namespace loopmend {
void FillController::open(const QStringList& paths, OpenMode mode) {
  if (paths.isEmpty()) return;
  load(paths, document_.has_scan() ? mode : OpenMode::replace,
       paths.size() == 1 ? tr("Opening %1").arg(QFileInfo(paths.first()).fileName())
                         : tr("Opening %1 files").arg(paths.size()));
}

void FillController::open_sample() { load({QString()}, OpenMode::replace, tr("Making the sample")); }

void FillController::load(const QStringList& paths, OpenMode mode, const QString& stage) {
  if (busy()) cancel();
  const JobPtr job = begin(Activity::opening, stage);
  std::optional<Vec3> origin;
  if (mode == OpenMode::add) origin = document_.origin();
  LoadStages stages;
  stages.stage = [this, job, is_one = paths.size() == 1](const QString& words, double share) {
    job->post([this, is_one, words, share] {
      Q_EMIT stage_changed(words);
      if (is_one) Q_EMIT share_done(share);
    });
  };
  const auto report = [this](const QString& words) {
    drop_preview();
    report_failure(words);
  };
  const auto open_all = [this, job, stages, paths, mode, origin, report]() mutable {
    OpenMode next = mode;
    for (const QString& path : paths) {
      try {
        if (next == OpenMode::replace)
          stages.picture = [this, job](auto shape) {
            job->post([this, shape] {
              document_.set_aside();  // its facts do not belong to this picture
              Q_EMIT preview_ready(shape);
            });
          };
        stages.opened = [this, job, next](const OpenedScanPtr& scan) {
          job->post([this, scan, next] {
            on_opened(scan, next);
            Q_EMIT logged(labels::import_summary(*scan) +
                          tr(" Opened in %1 s.").arg(labels::seconds(clock_.elapsed())));
            for (const Message& problem : scan->color_problems) Q_EMIT logged(labels::in_words(problem));
            if (!scan->color_problems.empty())
              Q_EMIT notice(scan->name + QStringLiteral(": ") + labels::in_words(scan->color_problems.front()));
            if (scan->loops.empty()) Q_EMIT notice(tr("%1 is closed: it has no hole to fill.").arg(scan->name));
          });
        };
        const OpenedScanPtr scan = load_scan(path, origin, stages, job->token());
        if (!scan) return;
        origin = origin.value_or(scan->origin);
        next = OpenMode::add;
        stages.picture = nullptr;
        stages.stage(tr("Computing curvature"), 1);
        add_curvature(scan, job);
      } catch (const std::exception& error) {  // the other files are opened nevertheless
        job->post([report, words = labels::in_words(message_of(error))] { report(words); });
      }
    }
    job->post([this] { end(); });
  };
  tasks_.start(job, open_all, [this, report](const QString& words) {
    report(words);
    end();
  });
}

void FillController::drop_preview() {
  Q_EMIT preview_dropped();
  document_.bring_back();
}

int FillController::on_opened(const OpenedScanPtr& scan, OpenMode mode) {
  if (mode == OpenMode::replace) {
    cancel_curvature();
    sessions_.clear();
    scan_contexts_.clear();
    undo_.clear();
    document_.clear();
  }
  const int index = document_.add_scan(scan);
  if (mode == OpenMode::add) undo_.push(std::make_unique<AddScan>(document_, index, tr("Add %1").arg(scan->name)));
  if (mode == OpenMode::replace) undo_.mark_saved();
  Q_EMIT file_opened(scan->path);
  return index;
}

void FillController::show_color(const OpenedScanPtr& scan, SurfaceShapePtr shape) {
  scan->shape = shape;  // undo may bring it back
  for (int index : document_.scans())
    if (document_.held_scan(index) == scan) document_.set_shape(index, shape);
}

/// On a worker. The curvature of 14 million triangles takes ten seconds; holes can be filled meanwhile.
void FillController::add_curvature(const OpenedScanPtr& scan, const JobPtr& job) {
  if (scan->shape->reduced) {
    job->post([this, scan] {
      without_curvature_.push_back(scan);
      if (!curvature_job_) compute_next_curvature();
    });
    return;
  }
  const auto shape = colored_shape(*scan, job->token());
  job->post([this, scan, shape] { show_color(scan, shape); });
}

/// One scan after another: each takes all processors.
void FillController::compute_next_curvature() {
  curvature_job_.reset();
  if (without_curvature_.empty()) {
    if (!busy()) Q_EMIT stage_changed({});
    return;
  }
  const OpenedScanPtr scan = without_curvature_.front();
  without_curvature_.pop_front();
  const JobPtr job = curvature_job_ = std::make_shared<Job>(this);
  tasks_.run(
      job, [scan, job] { return colored_shape(*scan, job->token()); },
      [this, scan](const SurfaceShapePtr& shape) {
        show_color(scan, shape);
        compute_next_curvature();
      },
      [this](const QString& text) {
        compute_next_curvature();
        report_failure(text);
      });
}

void FillController::cancel_curvature() {
  without_curvature_.clear();
  if (!curvature_job_) return;
  std::exchange(curvature_job_, nullptr)->cancel();
  if (!busy()) Q_EMIT stage_changed({});
}

void FillController::close_scan(int scan) {
  if (busy() || !document_.scan(scan)) return;
  undo_.push(std::make_unique<CloseScan>(document_, scan, tr("Close %1").arg(document_.scan(scan)->name)));
}

namespace {

/// From its own place, or out of the session where it is not there, or is another by now.
OpenedScanPtr load_kept(const SessionScan& wanted, const std::optional<Vec3>& origin, const CancelToken& cancel) {
  if (!wanted.file) return load_scan(wanted.path, origin, {}, cancel);
  const QTemporaryDir folder;
  if (!folder.isValid())
    throw WriteError(file_path(folder.path()), say("cannot be written"), say("Make room for temporary files."));
  const OpenedScanPtr scan = load_scan(lay_out(*wanted.file, folder.path()), origin, {}, cancel);
  if (!scan) return scan;
  scan->path = wanted.path;
  scan->name = QFileInfo(wanted.path).fileName();
  scan->kept = wanted.file;
  return scan;
}

/// Where each scan of the session lies now. @returns the path of the first that is not found; empty if all are.
QString find_scans(std::vector<SessionScan>& scans, const SessionFile& file) {
  for (SessionScan& wanted : scans) {
    if (const auto moved = file.moved.find(wanted.path); moved != file.moved.end()) wanted.path = moved->second;
    if (wanted.made || wanted.file || wanted.path.isEmpty() || QFileInfo::exists(wanted.path)) continue;
    const QString missing = wanted.path;
    for (const auto& [old_place, place] : file.moved) {  // what lay together was moved together
      wanted.path = QFileInfo(place).dir().filePath(QFileInfo(missing).fileName());
      if (QFileInfo::exists(wanted.path)) break;
    }
    if (!QFileInfo::exists(wanted.path)) return missing;
  }
  return {};
}

[[noreturn]] void refuse_damaged(const QString& path, Message what) {
  throw ReadError(file_path(path), std::move(what), {},
                  say("Open the scan itself instead; the session file is damaged."));
}

/// With its loops and its surface as they belong to the scan. @param path  of the session, for errors.
/// @param budget  of its timeline, bytes
OpenPatch restored_patch(const SessionPatch& saved, const OpenedScan& scan, const Vec3& origin, const QString& path,
                         std::size_t budget) {
  OpenPatch patch;
  patch.scan = saved.scan;
  for (int number : saved.loop_numbers) {
    const auto found =
        std::find_if(scan.loops.begin(), scan.loops.end(), [&](const auto& loop) { return loop.number == number; });
    if (found == scan.loops.end()) refuse_damaged(path, say("a patch belongs to a hole that does not exist"));
    patch.loops.push_back(static_cast<int>(found - scan.loops.begin()));
  }
  const auto vertices = static_cast<int>(scan.model->soup_vertex.size());
  const auto shown = [&](const PatchState& from) {
    auto state = std::make_shared<PatchState>(from);
    for (int v = state->patch.free_count; v < state->patch.vertex_count(); ++v)
      if (const int own = state->patch.view_vertex[v]; own < 0 || own >= vertices)
        refuse_damaged(path, say("a patch names a vertex that its scan does not have"));
    state->shape = shape_of(state->patch, origin, scan.colors);
    show_deviation(*state);
    return state;
  };
  patch.state = shown(*saved.state);
  Timeline timeline;
  for (const PatchStatePtr& recorded : saved.timeline)
    timeline.push_back(recorded == saved.state ? patch.state : shown(*recorded));
  patch.timeline = timeline.empty()
                       ? start_timeline(patch.state)
                       : std::make_shared<const Timeline>(within(std::move(timeline), patch.state, budget));
  patch.acceptance = saved.acceptance;
  return patch;
}

}  // namespace

/// What a worker read of a session.
struct FillController::Restored {
  std::vector<OpenedScanPtr> scans;
  std::vector<std::string> units;                       ///< of each scan, as chosen; empty: not chosen
  std::vector<std::map<int, SeamContinuity>> shapes{};  ///< of each scan, by the numbers of loops
  std::vector<OpenPatch> patches;                       ///< loops by index within their scan; ids not set
  std::optional<SessionView> view;
  QString missing;  ///< a scan that is not where the session names it: nothing else was read
};

FillController::Restored FillController::restore(const SessionFile& file, const JobPtr& job) const {
  const QString& path = file.path;
  Session session = session_from_file(path);
  Restored restored;
  restored.missing = find_scans(session.scans, file);
  if (!restored.missing.isEmpty()) return restored;
  restored.view = session.view;
  std::optional<Vec3> origin;
  for (const SessionScan& wanted : session.scans) {
    if (wanted.made) {
      const Vec3 middle = origin.value_or(scene_origin(*wanted.made));
      restored.scans.push_back(made_scan(*wanted.made, wanted.name, middle));
      origin = middle;
      continue;
    }
    const OpenedScanPtr scan = load_kept(wanted, origin, job->token());
    if (!scan) return {};
    if (scan->fingerprint != wanted.fingerprint)
      throw ReadError(file_path(wanted.path), say("this file has changed since the session was saved"), {},
                      say("Put the old file back to restore the session, or open the new one by itself."));
    origin = origin.value_or(scan->origin);
    restored.scans.push_back(scan);
  }
  for (const SessionScan& wanted : session.scans) {
    restored.units.push_back(wanted.unit);
    restored.shapes.push_back(wanted.shapes);
  }
  for (const SessionPatch& saved : session.patches) {
    if (job->token().cancelled()) return {};
    const OpenedScan& scan = *restored.scans[saved.scan];
    restored.patches.push_back(restored_patch(saved, scan, *origin, path, timeline_budget_));
  }
  return restored;
}

void FillController::open_session(const SessionFile& session) {
  if (busy()) cancel();
  const JobPtr job = begin(Activity::opening, tr("Opening %1").arg(QFileInfo(session.path).fileName()));
  const auto open = [this, job, session] {
    auto restored = std::make_shared<Restored>(restore(session, job));
    if (!restored->missing.isEmpty()) {
      job->post([this, session, scan = restored->missing] {
        end();
        Q_EMIT scan_missing(session, scan);
      });
      return;
    }
    job->post([this, restored, session] { on_restored(*restored, session.path, session.shown_as); });
    for (const OpenedScanPtr& scan : restored->scans)
      if (scan->shape->H.empty()) add_curvature(scan, job);
    job->post([this] { end(); });
  };
  tasks_.start(job, open, [this](const QString& words) {
    end();
    report_failure(words);
  });
}

void FillController::on_restored(Restored restored, const QString& path, const QString& shown_as) {
  OpenMode mode = OpenMode::replace;
  std::vector<int> index;
  for (const OpenedScanPtr& scan : restored.scans) {
    if (mode == OpenMode::replace) {
      index.push_back(on_opened(scan, mode));
    } else {
      index.push_back(document_.add_scan(scan));
    }
    mode = OpenMode::add;
    for (const Message& problem : scan->color_problems) Q_EMIT logged(labels::in_words(problem));
  }
  for (OpenPatch& patch : restored.patches) {
    patch.scan = index[patch.scan];
    for (int& loop : patch.loops) loop += document_.first_loop_of(patch.scan);
    patch.id = document_.next_patch_id();
  }
  std::map<int, std::string> units;
  for (std::size_t k = 0; k < restored.units.size(); ++k)
    if (!restored.units[k].empty()) units[index[k]] = restored.units[k];
  document_.set_chosen_units(units);
  std::map<int, SeamContinuity> shapes;
  for (std::size_t k = 0; k < restored.shapes.size(); ++k)
    for (const auto& [number, shape] : restored.shapes[k])
      if (number >= 1 && number <= static_cast<int>(restored.scans[k]->loops.size()))
        shapes.emplace(document_.first_loop_of(index[k]) + number - 1, shape);
  document_.set_chosen_shapes(shapes);
  document_.replace({}, restored.patches);
  if (restored.view) Q_EMIT view_restored(*restored.view);
  const QString name = shown_as.isEmpty() ? QFileInfo(path).fileName() : shown_as;
  Q_EMIT logged(tr("Restored %1: %L2 patches, in %3 s.")
                    .arg(name)
                    .arg(restored.patches.size())
                    .arg(labels::seconds(clock_.elapsed())));
  if (shown_as.isEmpty()) {
    undo_.mark_saved();
    Q_EMIT session_saved(path);
  } else {
    undo_.mark_unsaved();
  }
}

void FillController::replace_scans(const std::vector<int>& gone, const OpenedScanPtr& come, const QString& text) {
  if (busy()) return;
  std::vector<std::unique_ptr<Change>> parts;
  const int index = document_.add_scan(come);
  keep_unit(gone, index);
  parts.push_back(std::make_unique<AddScan>(document_, index, text));
  for (int scan : gone)
    if (document_.scan(scan)) parts.push_back(std::make_unique<CloseScan>(document_, scan, text));
  undo_.push(std::make_unique<ChangeGroup>(std::move(parts), text));
}

void FillController::open_made(const std::vector<OpenedScanPtr>& scans) {
  if (busy()) cancel();
  on_opened(scans.front(), OpenMode::replace);
  for (std::size_t k = 1; k < scans.size(); ++k) document_.add_scan(scans[k]);
}

void FillController::save_session(const QString& path, KeepScans keep) {
  if (busy() || !document_.has_scan()) return;
  const JobPtr job = begin(Activity::writing, tr("Writing %1").arg(QFileInfo(path).fileName()));
  tasks_.run(
      job,
      [this, job, session = session_of(document_, view_), path, keep]() mutable {
        return writing_.take(*job, [&] {
          keep_scans(session, keep);
          write_session(session, path, job->token());
          return true;
        });
      },
      [this, path](bool) {
        end();
        undo_.mark_saved();
        Q_EMIT logged(tr("Saved the session as %1.").arg(QDir::toNativeSeparators(path)));
        Q_EMIT session_saved(path);
      },
      [this](const QString& text) { give_up(text); });
}

void FillController::export_to(const QString& path, const ExportChoice& choice) {
  if (busy() || !document_.has_scan()) return;
  const JobPtr job = begin(Activity::writing, tr("Writing %1").arg(QFileInfo(path).fileName()));
  tasks_.run(
      job,
      [this, job, task = export_task(document_, file_path(path), choice)] {
        static constexpr int parts = 200;  // of the bar
        int sent = -1;
        const auto tell = [&](double share) {
          const int part = static_cast<int>(parts * share);
          if (std::exchange(sent, part) == part) return;
          job->post([this, share, part] {
            Q_EMIT progress_changed(part, parts);
            Q_EMIT share_done(share);
          });
        };
        return writing_.take(*job, [&] { return export_scene(task, job->token(), tell); });
      },
      [this, path, content = choice.content](const ExportResult& result) { on_exported(result, path, content); },
      [this](const QString& text) { give_up(text); });
}

void FillController::on_exported(const ExportResult& result, const QString& path, ExportChoice::Content content) {
  end();
  // What was left out would be lost without a question.
  if (content == ExportChoice::Content::scene && result.left_open.empty()) undo_.mark_saved();
  QString text = tr("Wrote %1: %2 triangles.").arg(QDir::toNativeSeparators(path), labels::count(result.triangles));
  if (!result.not_kept.empty()) text += tr(" Not in it: %1.").arg(labels::not_kept(result.not_kept));
  if (result.largest_rounding > 0 && path.endsWith(QLatin1String(".stl"), Qt::CaseInsensitive))
    text += tr(" STL rounds: vertices were moved by up to %1; PLY keeps every digit.")
                .arg(labels::number(result.largest_rounding));
  if (!result.left_open.empty())
    text += tr(" Left open, because the patch cuts the surface or another patch: %1.")
                .arg(labels::holes(document_, result.left_open));
  for (const Message& remark : result.remarks) text += QLatin1Char(' ') + labels::in_words(remark);
  Q_EMIT logged(text);
  Q_EMIT notice(text);
}

}  // namespace loopmend
