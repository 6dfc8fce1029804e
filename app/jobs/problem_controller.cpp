// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/problem_controller.h"

#include "document/labels.h"
#include "document/message_words.h"
#include "jobs/problem_base.h"

#include <algorithm>
#include <mutex>

namespace loopmend {
namespace {

std::vector<PatchStatePtr> patches_of(const Document& document, const std::vector<int>& scans) {
  std::vector<PatchStatePtr> states;
  for (const OpenPatch& patch : document.patches())
    if (std::find(scans.begin(), scans.end(), patch.scan) != scans.end()) states.push_back(patch.state);
  return states;
}

}  // namespace

/// The newest state of a flow at work; the window takes it when it has time.
struct ProblemController::Post {
  std::mutex mutex;
  SurfaceShapePtr newest;
  int step = 0;
  double energy = 0;
  int free_vertices = 0;
};

ProblemController::ProblemController(Document& document, FillController& controller, QObject* parent)
    : QObject(parent),
      document_(document),
      controller_(controller) {
  connect(&document_, &Document::scans_changed, this, &ProblemController::watch_scans);
  connect(&document_, &Document::patches_changed, this, &ProblemController::watch_scans);
  connect(&document_, &Document::patch_moved, this, &ProblemController::watch_scans);
  connect(&document_, &Document::opened, this, &ProblemController::discard);
}

void ProblemController::go_to(Stage stage, const QString& words) {
  stage_ = stage;
  words_ = words;
  Q_EMIT stage_changed();
}

void ProblemController::forget() {
  drop(job_);
  base_.reset();
  posed_.reset();
  start_shape_.reset();
  solution_.reset();
  made_.reset();
  models_.clear();
  patches_.clear();
  picture_ = {};
}

void ProblemController::discard() {
  if (stage_ == Stage::none) return;
  forget();
  go_to(Stage::none, {});
  Q_EMIT picture_changed();
}

/// What a trial was posed on must still be there, as it was.
void ProblemController::watch_scans() {
  if (stage_ == Stage::none) return;
  for (std::size_t k = 0; k < request_.scans.size(); ++k) {
    const auto scan = document_.scan(request_.scans[k]);
    if (!scan || (k < models_.size() && scan->model != models_[k])) {
      discard();
      return;
    }
  }
  if (patches_of(document_, request_.scans) != patches_) discard();
}

void ProblemController::fail(const QString& words, Stage back_to) {
  job_.reset();
  go_to(back_to, {});
  Q_EMIT failed(labels::sentence(words));
}

void ProblemController::pose(ProblemRequest request) {
  forget();
  Q_EMIT picture_changed();
  request_ = std::move(request);
  for (int index : request_.scans) models_.push_back(document_.scan(index)->model);
  patches_ = patches_of(document_, request_.scans);
  job_ = std::make_shared<Job>(this);
  go_to(Stage::posing, tr("Making the start\u2026"));
  const auto work = [this, job = job_, parts = parts_of(document_, request_.scans), request = request_] {
    const auto base = std::make_shared<const ProblemBase>(make_base(parts));
    if (job->token().cancelled()) return;
    const auto posed = std::make_shared<const PosedProblem>(request.pose(*base, job->token()));
    if (job->token().cancelled()) return;
    const auto start = shape_of(posed->problem.start, parts.origin);
    const auto backdrop =
        request.around == ProblemRequest::Around::shown ? shape_without(*base, posed->replaced) : nullptr;
    job->post([this, base, posed, start, backdrop] { on_posed(base, posed, start, backdrop); });
  };
  tasks_.start(job_, work, [this](const QString& words) {
    forget();
    fail(words, Stage::none);
  });
}

void ProblemController::on_posed(std::shared_ptr<const ProblemBase> base, std::shared_ptr<const PosedProblem> posed,
                                 SurfaceShapePtr start, SurfaceShapePtr backdrop) {
  job_.reset();
  base_ = std::move(base);
  posed_ = std::move(posed);
  start_shape_ = std::move(start);
  picture_.hidden_scans = {request_.scans.begin(), request_.scans.end()};
  picture_.backdrop = std::move(backdrop);
  picture_.patch = start_shape_;
  picture_.arrival = Arrival::at_once;
  QString words = tr("%1 free vertices.").arg(labels::count(static_cast<std::size_t>(free_vertices())));
  if (!posed_->remark.empty())
    words += QLatin1Char(' ') + labels::sentence(labels::in_words(posed_->remark)) + QLatin1Char('.');
  go_to(Stage::posed, words);
  Q_EMIT picture_changed();
}

void ProblemController::evolve(const EvolutionOptions& options) {
  if (!posed_ || busy()) return;
  solution_.reset();
  made_.reset();
  job_ = std::make_shared<Job>(this);
  picture_.patch = start_shape_;
  picture_.arrival = Arrival::at_once;
  Q_EMIT picture_changed();
  go_to(Stage::evolving, tr("%1 at work\u2026").arg(labels::flow_name(options.flow)));
  const auto work = [this, job = job_, posed = posed_, options, origin = document_.origin(),
                     name = request_.made_name] {
    const auto post = std::make_shared<Post>();
    const auto on_step = [&](const Evolution& evolution, const StepRecord& record) {
      {
        const std::lock_guard lock(post->mutex);
        if (post->newest || job->token().cancelled()) return;  // the last one has not been drawn yet
      }
      const auto shape = shape_of(evolution.patch(), origin);
      {
        const std::lock_guard lock(post->mutex);
        post->newest = shape;
        post->step = record.step;
        post->energy = record.energy;
        post->free_vertices = evolution.patch().free_count;
      }
      job->post([this, post] { show_state(post); });
    };
    auto solution = std::make_shared<Solution>(posed->solve(options, on_step, job->token()));
    if (job->token().cancelled()) return;
    OpenedScanPtr made;
    if (solution->refusal.empty()) made = made_scan(solution->surface, name, origin);
    const auto shape = shape_of(solution->outcome.patch, origin);
    job->post([this, solution, made, shape] { on_solved(solution, made, shape); });
  };
  tasks_.start(job_, work, [this](const QString& words) { fail(words, Stage::posed); });
}

void ProblemController::show_state(const std::shared_ptr<Post>& post) {
  int step = 0, vertices = 0;
  double energy = 0;
  {
    const std::lock_guard lock(post->mutex);
    picture_.patch = std::exchange(post->newest, nullptr);
    picture_.arrival = Arrival::with_the_next;
    step = post->step;
    energy = post->energy;
    vertices = post->free_vertices;
  }
  go_to(Stage::evolving, tr("Step %1, energy %2, %3 vertices").arg(step).arg(labels::number(energy)).arg(vertices));
  Q_EMIT picture_changed();
}

void ProblemController::on_solved(std::shared_ptr<const Solution> solution, const OpenedScanPtr& made,
                                  SurfaceShapePtr shape) {
  job_.reset();
  if (!made) {
    picture_.patch = start_shape_;
    picture_.arrival = Arrival::at_once;
    fail(labels::in_words(solution->refusal) + QLatin1Char('.'), Stage::posed);
    Q_EMIT picture_changed();
    return;
  }
  solution_ = std::move(solution);
  made_ = made;
  picture_.patch = std::move(shape);
  picture_.arrival = Arrival::soon;
  const bool rest = solution_->outcome.status == PatchStatus::converged;
  QString words =
      (rest ? tr("Converged after %1 steps, energy %2 \u2192 %3.") : tr("%1 steps, energy %2 \u2192 %3."))
          .arg(solution_->outcome.steps)
          .arg(labels::number(solution_->outcome.energy.initial), labels::number(solution_->outcome.energy.final));
  if (!solution_->outcome.message.empty())
    words += QLatin1Char(' ') + labels::sentence(labels::in_words(solution_->outcome.message)) + QLatin1Char('.');
  go_to(Stage::solved, words);
  Q_EMIT picture_changed();
}

void ProblemController::cancel() {
  if (!busy()) return;
  drop(job_);
  if (!posed_) {
    discard();
    return;
  }
  picture_.patch = start_shape_;
  picture_.arrival = Arrival::at_once;
  go_to(Stage::posed, tr("Cancelled."));
  Q_EMIT picture_changed();
}

void ProblemController::accept() {
  if (stage_ != Stage::solved || controller_.busy()) return;
  const OpenedScanPtr made = made_;
  const std::vector<int> scans = request_.scans;
  const QString words = request_.name;
  discard();
  controller_.replace_scans(scans, made, words);
  Q_EMIT accepted(tr("%1: applied. Ctrl+Z undoes it.").arg(words));
}

ComparisonSource ProblemController::comparison_source() const {
  return {request_.name, [start = posed_->problem.start](const CancelToken&) { return start; }, picture_.backdrop,
          document_.origin()};
}

QString ProblemController::adopt(const ComparedRun& flow_run) {
  if (!posed_ || busy() || controller_.busy()) return tr("The main window is busy, or has gone on to something else.");
  job_ = std::make_shared<Job>(this);
  go_to(Stage::evolving, tr("Taking over\u2026"));
  struct Taken {
    std::shared_ptr<const Solution> solution;
    OpenedScanPtr made;
    SurfaceShapePtr shape;
  };
  tasks_.run(
      job_,
      [posed = posed_, flow_run, origin = document_.origin(), name = request_.made_name] {
        auto solution = std::make_shared<Solution>();
        solution->outcome = flow_run;
        solution->surface = posed->problem.surface(flow_run.patch);
        const OpenedScanPtr made = made_scan(solution->surface, name, origin);
        return Taken{std::move(solution), made, flow_run.shape};
      },
      [this](const Taken& taken) {
        on_solved(taken.solution, taken.made, taken.shape);
        accept();
      },
      [this](const QString& text) { fail(text, Stage::posed); });
  return tr("%1 was applied in the main window; Ctrl+Z there undoes it.").arg(labels::flow_name(flow_run.flow));
}

bool ProblemController::shut_down(std::chrono::milliseconds at_most) { return tasks_.stop(at_most); }

}  // namespace loopmend
