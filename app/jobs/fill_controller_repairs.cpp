// SPDX-License-Identifier: GPL-3.0-or-later
// What the controller does to scans themselves: each change makes another scan, which comes in the place of the old one.
#include "core/error.h"
#include "document/labels.h"
#include "document/message_words.h"
#include "jobs/defect_places.h"
#include "jobs/fill_controller.h"
#include "jobs/remaining_time.h"
#include "jobs/repair_scan.h"
#include "jobs/repair_words.h"

#include <QMetaMethod>

namespace loopmend {

void FillController::repair_scans(ScanRepair what, const std::set<int>& loops) {
  if (busy()) return;
  std::map<int, ScanRepairTask> by_scan;
  for (int loop : loops)
    if (document_.present(loop)) by_scan[document_.scan_of(loop)].loops.push_back(document_.loop(loop));
  if (loops.empty() && (what == ScanRepair::stitch || what == ScanRepair::repair || what == ScanRepair::prepare ||
                        what == ScanRepair::turn_around))
    for (int scan : document_.scans()) by_scan[scan];
  if (by_scan.empty()) return;
  std::vector<ScanRepairTask> tasks;
  for (auto& [scan, task] : by_scan) {
    task.scan = scan;
    tasks.push_back(std::move(task));
  }
  run_repair(what, std::move(tasks));
}

void FillController::repair(const std::set<Defect>& defects) {
  if (busy()) return;
  std::vector<ScanRepairTask> tasks;
  for (int scan : document_.scans()) {
    ScanRepairTask task;
    task.scan = scan;
    task.defects = defects;
    tasks.push_back(std::move(task));
  }
  if (!tasks.empty()) run_repair(ScanRepair::repair, std::move(tasks));
}

void FillController::turn_around(int scan) {
  if (busy() || !document_.scan(scan)) return;
  ScanRepairTask task;
  task.scan = scan;
  run_repair(ScanRepair::turn_around, {std::move(task)});
}

void FillController::bridge(int scan, int soup_a, int soup_b) {
  if (busy() || !document_.scan(scan)) return;
  ScanRepairTask task;
  task.scan = scan;
  task.bridge_ends = {soup_a, soup_b};
  run_repair(ScanRepair::bridge, {std::move(task)});
}

void FillController::build_base(int loop, double distance) {
  if (busy() || !document_.present(loop)) return;
  ScanRepairTask task;
  task.scan = document_.scan_of(loop);
  task.loops = {document_.loop(loop)};
  task.base_distance = distance;
  run_repair(ScanRepair::base, {std::move(task)}, {});
}

void FillController::cut_by_plane(int scan, const CutPlane& plane) {
  if (busy() || !document_.scan(scan)) return;
  ScanRepairTask task;
  task.scan = scan;
  task.cut_plane = plane;
  run_repair(ScanRepair::plane_cut, {std::move(task)}, {});
}

void FillController::fill_part(const HolePart& part, const FillAndSmooth& how) {
  if (busy() || !document_.scan(part.scan)) return;
  ScanRepairTask task;
  task.scan = part.scan;
  task.bridge_ends = {part.from, part.to};
  task.part_to_fill = part.beside;
  run_repair(ScanRepair::bridge, {std::move(task)}, how);
}

void FillController::erase(int scan, const std::vector<int>& points, const std::optional<FillAndSmooth>& then) {
  if (busy() || !document_.scan(scan) || points.empty()) return;
  ScanRepairTask task;
  task.scan = scan;
  task.erased = points;
  run_repair(ScanRepair::erase, {std::move(task)}, then);
}

void FillController::run_repair(ScanRepair what, std::vector<ScanRepairTask> tasks,
                                const std::optional<FillAndSmooth>& then) {
  for (ScanRepairTask& task : tasks) {
    task.opened = document_.scan(task.scan);
    task.first_loop = document_.first_loop_of(task.scan);
    for (const OpenPatch& patch : document_.patches())
      if (patch.scan == task.scan) task.patches.push_back(patch);
  }
  const JobPtr job = begin(Activity::filling, repair_title(what));
  const double count = static_cast<double>(tasks.size());
  for (std::size_t k = 0; k < tasks.size(); ++k) {
    tasks[k].cancel = job->token();
    QString title = repair_title(what);
    if (tasks.size() > 1) title = tr("%1 (%2)").arg(title, tasks[k].opened->name);
    std::function<double(const RepairStep&)> share;
    if (what == ScanRepair::repair)
      share = [k, count, defects = tasks[k].defects](const RepairStep& step) {
        return (static_cast<double>(k) + share_of_repair(defects, step)) / count;
      };
    if (what == ScanRepair::prepare)
      share = [k, count, done = 0.0](const RepairStep& step) mutable {
        done = share_of_preparing(step.stage, done);
        return (static_cast<double>(k) + done) / count;
      };
    tasks[k].on_step = [this, job, title, share](const RepairStep& step) {
      const double done = share ? share(step) : 0;
      job->post([this, title, share, step, done] {
        show_repair_step(title, step);
        if (share) show_share(done);
      });
    };
  }
  tasks_.run(
      job,
      [what, tasks, origin = document_.origin()] {
        Repairs result;
        std::vector<RepairedScan>& all = result.scans;
        std::vector<FacesToChange> changes;
        for (const ScanRepairTask& task : tasks) {
          try {
            if (auto scan = repaired_scan(what, task)) all.push_back(std::move(*scan));
          } catch (const Error& error) {  // one scan does not take the others with it
            RepairedScan failed;
            failed.scan = task.scan;
            failed.words = labels::in_words(error.message());
            all.push_back(std::move(failed));
          }
          if (!all.empty() && all.back().scan == task.scan && !all.back().proposal.isEmpty())
            changes.push_back({task.opened, all.back().changed_faces});
        }
        if (!changes.empty()) result.places = std::make_shared<const DefectPlaces>(mark_faces(changes, origin));
        return result;
      },
      [this, what, then](const Repairs& repairs) { on_repaired(repairs, what, then); },
      [this](const QString& text) { give_up(text); });
}

void FillController::show_repair_step(const QString& title, const RepairStep& step) {
  Q_EMIT stage_changed(repair_step(title, step));
  Q_EMIT done_so_far(list_of(step.so_far).join(QStringLiteral(", ")));
}

void FillController::show_share(double share) {
  constexpr int all = 100;
  Q_EMIT progress_changed(static_cast<int>(all * share), all);
  Q_EMIT share_done(share);
}

namespace {

/// More boundary loops than a person overlooks at a glance.
constexpr std::size_t many_new_loops = 10;

RepairQuestion question_on(const std::vector<RepairedScan>& all) {
  RepairQuestion question;
  QStringList words, proposals;
  for (const RepairedScan& one : all) {
    if (!one.made) continue;
    words << one.words;
    if (!one.proposal.isEmpty()) proposals << one.proposal;
    question.patches += one.lost_patches;
    question.loops_before += one.loops_before;
    question.loops += one.loops;
  }
  question.done = words.join(QLatin1Char('\n'));
  question.proposal = proposals.join(QLatin1Char(' '));
  return question;
}

}  // namespace

void FillController::on_repaired(const Repairs& repairs, ScanRepair what, const std::optional<FillAndSmooth>& then) {
  end();
  const std::vector<RepairedScan>& all = repairs.scans;
  RepairQuestion question = question_on(all);
  question.apply = [this, all, what, then] {
    for (const RepairedScan& one : all)
      if (busy() || !document_.scan(one.scan)) return;
    apply_repaired(all, what, then);
  };
  if (repairs.places && isSignalConnected(QMetaMethod::fromSignal(&FillController::repair_proposed))) {
    question.places = repairs.places;
    Q_EMIT repair_proposed(question);
    return;
  }
  const bool opens_much = what != ScanRepair::erase && question.loops > question.loops_before + many_new_loops;
  const bool is_heard = isSignalConnected(QMetaMethod::fromSignal(&FillController::repair_questioned));
  if ((question.patches == 0 && !opens_much) || !is_heard) {
    apply_repaired(all, what, then);
    return;
  }
  Q_EMIT repair_questioned(question);
}

void FillController::apply_repaired(const std::vector<RepairedScan>& all, ScanRepair what,
                                    const std::optional<FillAndSmooth>& then) {
  std::set<int> to_fill;
  bool changed = false;
  for (const RepairedScan& one : all) {
    if (!one.made) {
      Q_EMIT notice(labels::sentence(one.words));
      Q_EMIT nothing_repaired(labels::sentence(one.words));
      continue;
    }
    changed = true;
    to_fill.merge(take_repaired(one));
    if (what != ScanRepair::bridge && what != ScanRepair::erase) Q_EMIT repaired(one.words);
  }
  if (all.empty()) {
    Q_EMIT notice(nothing_to_repair(what));
    Q_EMIT nothing_repaired(nothing_to_repair(what));
  }
  if (!to_fill.empty()) Q_EMIT holes_made(to_fill);
  if (!then || !changed) return;
  if (to_fill.empty()) {
    Q_EMIT notice(
        tr("No hole was made that could be filled: what was erased lay at an outer rim, or was a whole component."));
    return;
  }
  start_fill({to_fill, then->choice, {}, then->options, Pace::steady, PatchChange::Joining::previous});
}

void FillController::choose_unit(const std::string& unit) {
  if (busy() || !document_.has_scan()) return;
  std::map<int, std::string> units = document_.chosen_units();
  for (int scan : document_.scans()) units[scan] = unit;
  if (units == document_.chosen_units()) return;
  const QString text = unit.empty() ? tr("Lengths without a unit") : tr("Lengths in %1").arg(labels::unit_name(unit));
  undo_.push(std::make_unique<ChooseUnits>(document_, std::move(units), text));
}

/// A scan in the place of others keeps the unit that was chosen for the first of them.
void FillController::keep_unit(const std::vector<int>& gone, int come) {
  std::map<int, std::string> units = document_.chosen_units();
  for (int scan : gone)
    if (const auto chosen = units.find(scan); chosen != units.end() && units.emplace(come, chosen->second).second)
      break;
  if (units != document_.chosen_units()) document_.set_chosen_units(units);
}

void FillController::choose_shape(const std::set<int>& loops, const std::optional<SeamContinuity>& shape) {
  if (busy()) return;
  std::map<int, SeamContinuity> shapes = document_.chosen_shapes();
  for (int loop : loops) {
    shapes.erase(loop);
    if (shape) shapes.emplace(loop, *shape);
  }
  if (shapes == document_.chosen_shapes()) return;
  const QString where = labels::holes(document_, loops);
  const QString text =
      shape ? tr("Close %1: %2").arg(where, labels::shape(*shape)) : tr("Close %1 as usual").arg(where);
  undo_.push(std::make_unique<ChooseShapes>(document_, std::move(shapes), text));
}

/// Loops that are the same in the scan that comes in the place of another keep the shapes that were chosen for them.
void FillController::keep_shapes(int gone, int come) {
  std::map<int, SeamContinuity> shapes = document_.chosen_shapes();
  const auto key_of = [this](int loop) {
    const BoundaryLoop& l = document_.loop(loop);
    return std::tuple(l.edges(), l.perimeter, l.center.x(), l.center.y(), l.center.z());
  };
  std::map<decltype(key_of(0)), SeamContinuity> of_gone;
  for (const auto& [loop, shape] : shapes)
    if (document_.scan_of(loop) == gone) of_gone.emplace(key_of(loop), shape);
  if (of_gone.empty()) return;
  for (int loop = document_.first_loop_of(come); loop < document_.loop_count(); ++loop)
    if (const auto same = of_gone.find(key_of(loop)); document_.scan_of(loop) == come && same != of_gone.end())
      shapes.emplace(loop, same->second);
  document_.set_chosen_shapes(shapes);
}

std::set<int> FillController::take_repaired(const RepairedScan& repaired) {
  const int come = document_.add_scan(repaired.made), first_loop = document_.first_loop_of(come);
  keep_unit({repaired.scan}, come);
  keep_shapes(repaired.scan, come);
  std::vector<PatchChange::Pair> pairs;
  for (OpenPatch patch : repaired.carried) {
    patch.scan = come;
    patch.id = document_.next_patch_id();
    for (int& loop : patch.loops) loop += first_loop;
    pairs.push_back({std::nullopt, std::move(patch)});
  }
  std::vector<std::unique_ptr<Change>> parts;
  parts.push_back(std::make_unique<AddScan>(document_, come, repaired.title));
  parts.push_back(std::make_unique<CloseScan>(document_, repaired.scan, repaired.title));
  if (!pairs.empty()) parts.push_back(std::make_unique<PatchChange>(document_, std::move(pairs), repaired.title));
  undo_.push(std::make_unique<ChangeGroup>(std::move(parts), repaired.title));
  QString words = repaired.words;
  if (repaired.joined_patches > 0)
    words += QLatin1Char(' ') + tr("%Ln patch(es) are a part of the scan now.", nullptr, repaired.joined_patches);
  Q_EMIT logged(words);
  if (repaired.lost_patches > 0)
    Q_EMIT notice(tr("%1 %Ln patch(es) of this scan were removed.", nullptr, repaired.lost_patches).arg(words));
  std::set<int> to_fill;
  for (int loop : repaired.to_fill) to_fill.insert(first_loop + loop);
  return to_fill;
}

}  // namespace loopmend
