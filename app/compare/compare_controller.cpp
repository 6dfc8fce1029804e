// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/compare_controller.h"

#include "document/labels.h"
#include "document/preferences.h"
#include "panels/window_place.h"
#include "pipeline/problem.h"

#include <QGuiApplication>
#include <QScreen>

namespace loopmend {
namespace {

/// The run as a patch of the document: the start and where the flow has led.
OpenPatch patch_of(const ComparedRun& start, const ComparedRun& flow_run, double density) {
  auto initial = std::make_shared<PatchState>();
  static_cast<PatchResult&>(*initial) = start;
  initial->status = PatchStatus::filled;
  initial->shape = start.shape;
  initial->seams_before = start.seams;
  initial->recipe.density = density;
  auto now = std::make_shared<PatchState>(*initial);
  static_cast<PatchResult&>(*now) = flow_run;
  now->history.clear();
  now->seams_before = start.seams;
  now->shape = flow_run.shape;
  // `loopmend fill` would solve several holes one by one.
  const bool nameable = start.patch.loops.size() == 1 && flow_run.stage == ComparedRun::Stage::ended;
  RunRecipe run = recipe_of(flow_run.options);
  run.steps = flow_run.steps;
  if (!nameable) run.end = RunRecipe::End::unnamed;
  now->recipe.runs.push_back(run);
  OpenPatch patch;
  patch.timeline = std::make_shared<Timeline>(Timeline{initial, now});
  patch.state = now;
  return patch;
}

/// What closes just these loops in the document, to be compared with the flows; null: nothing, or it closes others, too.
ComparedRunPtr filled_patch(const Document& document, const std::set<int>& loops) {
  const OpenPatch* patch = loops.empty() ? nullptr : document.patch_of(*loops.begin());
  if (!patch || loops_of(*patch) != loops) return nullptr;
  auto filled = std::make_shared<ComparedRun>();
  static_cast<PatchResult&>(*filled) = *patch->state;
  filled->stage = ComparedRun::Stage::ended;
  filled->shape = patch->state->shape;
  filled->energies = patch_energies(filled->patch);
  filled->wide_jump = wide_curvature_jump(filled->patch);
  return filled;
}

}  // namespace

CompareController::CompareController(const Document& document, const HoleSelection& selection,
                                     FillController& controller, QWidget* window)
    : QObject(window),
      document_(document),
      selection_(selection),
      controller_(controller),
      window_(window) {
  undertaker_.setInterval(100);
  connect(&undertaker_, &QTimer::timeout, this, &CompareController::bury);
}

std::set<int> CompareController::loops() const {
  std::set<int> chosen;
  for (int loop : selection_.selected())
    if (document_.present(loop) && document_.loop(loop).kind != LoopKind::cut) chosen.insert(loop);
  if (chosen.empty())
    for (int loop = 0; loop < document_.loop_count(); ++loop)
      if (document_.present(loop) && document_.loop(loop).kind == LoopKind::hole) chosen.insert(loop);
  return chosen;
}

CompareWindow* CompareController::compare_holes(const Look& look) {
  const std::set<int> chosen = loops();
  if (chosen.empty()) {
    Q_EMIT failed(
        tr("There is no hole to compare flows on. Open a scan with holes, or pose a region, points or a bridge."));
    return nullptr;
  }
  const int scan = document_.scan_of(*chosen.begin());
  std::vector<BoundaryLoop> holes;
  double density = 1;
  for (int loop : chosen) {
    if (document_.scan_of(loop) != scan) {
      Q_EMIT failed(tr("The holes belong to several scans. Select holes of one of them."));
      return nullptr;
    }
    holes.push_back(document_.loop(loop));
    if (const OpenPatch* patch = document_.patch_of(loop)) density = patch->state->recipe.density;
  }
  const auto opened = document_.scan(scan);
  const OpenPatch* patch = document_.patch_of(*chosen.begin());
  const PatchStatePtr filled = patch ? patch->state : nullptr;
  std::erase_if(of_holes_, [](const OfHoles& shown) { return shown.window.isNull(); });
  for (const OfHoles& shown : of_holes_)
    if (shown.model == opened->model && shown.loops == chosen && shown.density == density && shown.filled == filled) {
      shown.window->showNormal();
      shown.window->raise();
      shown.window->activateWindow();
      return shown.window;
    }
  CompareTask task;
  task.source.title = tr("%1 of %2").arg(labels::sentence(labels::holes(document_, chosen)), opened->name);
  task.source.start = [model = opened->model, holes, density](const CancelToken& cancel) {
    return pose_holes(model, holes, InitialPatchOptions{density}, cancel).problem.start;
  };
  task.command = holes_words(document_, chosen, density);
  task.source.neighborhood = opened->shape;
  task.unit = labels::unit_symbol(document_.unit(scan));
  task.source.origin = document_.origin();
  task.filled = filled_patch(document_, chosen);
  task.accept_help = tr("Put this patch into the holes, in place of what is there; can be undone");
  task.accept = [this, scan, model = opened->model, density](const ComparedRun& start, const ComparedRun& flow_run) {
    const auto now = document_.scan(scan);
    if (!now || now->model != model) return tr("The scan of this comparison is no longer open.");
    if (controller_.busy()) return tr("The main window is busy. Try again when it is done.");
    OpenPatch patch = patch_of(start, flow_run, density);
    patch.scan = scan;
    for (int number : flow_run.patch.loop_numbers)
      for (int loop = document_.first_loop_of(scan); loop < document_.loop_count(); ++loop)
        if (document_.scan_of(loop) == scan && document_.loop(loop).number == number) patch.loops.push_back(loop);
    controller_.adopt(std::move(patch));
    return tr("%1 was applied in the main window; Ctrl+Z there undoes it.").arg(labels::flow_name(flow_run.flow));
  };
  CompareWindow* window = compare(std::move(task), look);
  of_holes_.push_back({window, opened->model, chosen, density, filled});
  return window;
}

CompareWindow* CompareController::compare_trial(ProblemController& trial, const Look& look) {
  if (!trial.can_compare()) return nullptr;
  CompareTask task;
  task.source = trial.comparison_source();
  task.command = trial.command();
  task.unit = labels::unit_symbol(document_.unit());
  task.accept_help = tr("Put this surface into the document, in place of what it came from; can be undone");
  task.accept = [at = QPointer<ProblemController>(&trial)](const ComparedRun&, const ComparedRun& flow_run) {
    return at ? at->adopt(flow_run) : QString();
  };
  return compare(std::move(task), look);
}

CompareWindow* CompareController::compare(CompareTask task, const Look& look) {
  auto flow_comparison = std::make_unique<ComparisonController>(task.source);
  auto* window = new CompareWindow(*flow_comparison, std::move(task), look, window_);
  window->setAttribute(Qt::WA_DeleteOnClose);
  place(*window);
  open_.emplace_back(window, std::move(flow_comparison));
  connect(window, &QObject::destroyed, this, &CompareController::bury);
  window->show();
  Q_EMIT opened(window);
  return window;
}

/// Where the last one was, a little aside of one that is open.
void CompareController::place(CompareWindow& window) const {
  const bool is_kept = window.restoreGeometry(load_compare_place());
  if (is_kept && (window.isMaximized() || window.isFullScreen())) return;
  const QScreen* screen = QGuiApplication::screenAt(window_->geometry().center());
  if (!screen) screen = QGuiApplication::primaryScreen();
  QRect place = window.geometry();
  if (!is_kept) {
    QRect needed = window_->geometry();
    if (in_sight_) needed = {in_sight_->mapToGlobal(QPoint(0, 0)), in_sight_->size()};
    place = place_beside(window_->frameGeometry(), needed, window.size(), window.minimumSizeHint().width(),
                         screen->availableGeometry().marginsRemoved(usual_frame));
  }
  constexpr QPoint aside(30, 30);
  for (const auto& [other, flow_comparison] : open_)
    if (other && other->isVisible() && other->geometry().topLeft() == place.topLeft()) place.translate(aside);
  window.setGeometry(onto_screen(place));
}

/// A closed comparison goes when its last worker has looked at its token.
void CompareController::bury() {
  for (auto& [window, flow_comparison] : open_)
    if (!window) closed_.push_back(std::move(flow_comparison));
  std::erase_if(open_, [](const auto& entry) { return entry.second == nullptr; });
  std::erase_if(closed_,
                [](const auto& flow_comparison) { return flow_comparison->shut_down(std::chrono::milliseconds(0)); });
  closed_.empty() ? undertaker_.stop() : undertaker_.start();
}

bool CompareController::shut_down(std::chrono::milliseconds at_most) {
  bool all = true;
  for (auto& [window, flow_comparison] : open_)
    if (window && window->isVisible()) window->keep_place();
  for (auto& [window, flow_comparison] : open_) all = flow_comparison->shut_down(at_most) && all;
  for (auto& flow_comparison : closed_) all = flow_comparison->shut_down(at_most) && all;
  return all;
}

}  // namespace loopmend
