// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/comparison_controller.h"

#include "analysis/surface_distance.h"
#include "core/seconds_since.h"
#include "io/read_mesh.h"
#include "jobs/near_shape.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <mutex>
#include <set>

namespace loopmend {
namespace {

using Clock = std::chrono::steady_clock;

/// What is shown of a patch.
std::shared_ptr<ComparedRun> seen(const Patch& patch, int edge, const Vec3& origin) {
  auto state = std::make_shared<ComparedRun>();
  state->patch = patch;
  state->shape = shape_of(patch, origin);
  state->seams = seam_reports(patch);
  state->wide_jump = std::numeric_limits<double>::quiet_NaN();
  if (!patch.loops.empty()) state->profile = profile_across(patch, edge);
  return state;
}

/// The triangles of a patch and of the rings around it, mesh units.
TriangleSoup surface_of(const Patch& patch) {
  TriangleSoup soup;
  for (const Vec3& p : patch.positions) soup.points.push_back(patch.to_mesh(p));
  soup.triangles = patch.triangles;
  return soup;
}

/// What distances are measured from.
struct DistanceSurface {
  TriangleSoup soup;
  SurfaceTree tree;

  explicit DistanceSurface(TriangleSoup surface) : soup(std::move(surface)), tree(soup.points, soup.triangles) {}
};

/// The same state with the distances of its free vertices, and a shape with those of all vertices of its own triangles.
ComparedRunPtr with_distances(const ComparedRun& state, const DistanceSurface& from, const CancelToken& cancel) {
  auto measured = std::make_shared<ComparedRun>(state);
  const Patch& patch = state.patch;
  const auto free = static_cast<std::size_t>(patch.free_count);
  std::set<int> boundary;
  for (int f = 0; f < patch.patch_triangles; ++f)
    for (int v : patch.triangles[f])
      if (v >= patch.free_count) boundary.insert(v);
  Points points;
  for (int v = 0; v < patch.free_count; ++v) points.push_back(patch.to_mesh(patch.positions[v]));
  for (int v : boundary) points.push_back(patch.to_mesh(patch.positions[v]));
  const std::vector<double> distances = signed_distances(points, from.soup, from.tree, cancel);
  measured->distances.assign(distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(free));
  auto shape = std::make_shared<SurfaceShape>(*state.shape);
  shape->difference.assign(shape->points.size() / 3, std::numeric_limits<float>::quiet_NaN());
  std::copy(measured->distances.begin(), measured->distances.end(), shape->difference.begin());
  std::size_t next = free;
  for (int v : boundary) shape->difference[v] = static_cast<float>(distances[next++]);
  measured->shape = std::move(shape);
  return measured;
}

ComparedRunPtr without_distances(const ComparedRun& state) {
  auto plain = std::make_shared<ComparedRun>(state);
  plain->distances.clear();
  if (!state.shape->difference.empty()) {
    auto shape = std::make_shared<SurfaceShape>(*state.shape);
    shape->difference.clear();
    plain->shape = std::move(shape);
  }
  return plain;
}

/// Where H jumps most at the start: there the profile is taken until all flows have ended.
int first_edge(const Patch& patch) {
  if (patch.loops.empty()) return 0;
  const std::vector<double> jumps = seam_jumps(patch, 0);
  std::size_t best = 0;
  for (std::size_t i = 0; i < jumps.size(); ++i)
    if (std::isfinite(jumps[i]) && (!std::isfinite(jumps[best]) || jumps[i] > jumps[best])) best = i;
  return static_cast<int>(best);
}

}  // namespace

/// What the runs have for the window: the newest state of each, and every point of its curves.
struct ComparisonController::Post {
  explicit Post(std::size_t flow_runs) : newest(flow_runs), points(flow_runs), runs(flow_runs) {}

  std::mutex mutex;
  std::vector<ComparedRunPtr> newest;                ///< not yet taken
  std::vector<std::vector<ComparisonPoint>> points;  ///< likewise
  std::vector<ComparedFlow> runs;
  std::size_t ended = 0;
  bool waiting = false;  ///< the window has been asked to come
  FlowComparison comparison;
  int edge = 0;
};

ComparisonController::ComparisonController(ComparisonSource source, QObject* parent)
    : QObject(parent),
      source_(std::move(source)) {
  forget_results();
  prepare();
}

void ComparisonController::prepare() {
  job_ = std::make_shared<Job>(this);
  struct Prepared {
    SurfaceShapePtr close;
    ComparedRunPtr start;
  };
  tasks_.run(
      job_,
      [job = job_, source = source_]() -> Prepared {
        const Patch patch = source.start(job->token());
        if (job->token().cancelled()) return {};
        const auto close = source.neighborhood ? near_shape(source.neighborhood, patch, source.origin) : nullptr;
        auto state = seen(patch, first_edge(patch), source.origin);
        state->energies = patch_energies(patch);
        return {close, state};
      },
      [this](const Prepared& prepared) {
        job_.reset();
        neighborhood_ = prepared.close;
        start_ = prepared.start;
        forget_results();
        stage_ = Stage::ready;
        Q_EMIT stage_changed();
        measure();
      },
      [this](const QString& text) {
        job_.reset();
        stage_ = Stage::failed;
        Q_EMIT stage_changed();
        Q_EMIT failed(text);
      });
}

void ComparisonController::forget_results() {
  comparison_.reset();
  newest_.clear();
  if (start_) start_ = without_distances(*start_);
  curves_.assign(flows_.size(), {});
  for (FlowKind flow : flows_) {
    if (!start_) {
      newest_.push_back(nullptr);
      continue;
    }
    auto state = std::make_shared<ComparedRun>(*start_);
    state->flow = flow;
    newest_.push_back(std::move(state));
  }
  if (!start_) return;
  for (auto& curve : curves_) curve.push_back({0, start_->energies});
}

void ComparisonController::set_flows(const std::vector<FlowKind>& flows) {
  if (stage_ == Stage::running || flows == flows_) return;
  flows_ = flows;
  forget_results();
  Q_EMIT stage_changed();
  measure();
}

void ComparisonController::measure_from(const std::optional<DistanceFrom>& from) {
  if (from == from_) return;
  from_ = from;
  measure();
}

/// Of the surface before: they would stand under another one's name.
void ComparisonController::drop_distances() {
  if (start_->distances.empty()) return;
  start_ = without_distances(*start_);
  for (ComparedRunPtr& state : newest_) state = without_distances(*state);
  Q_EMIT measured();
}

void ComparisonController::measure() {
  drop(measuring_);
  if (!start_ || stage_ != Stage::ready) return;
  drop_distances();
  if (!from_) return;
  std::vector<ComparedRunPtr> states = newest_;
  states.push_back(start_);
  const Patch* patch = from_->kind == DistanceFrom::Kind::start ? &start_->patch : nullptr;
  for (const ComparedRunPtr& state : newest_)
    if (from_->kind == DistanceFrom::Kind::flow && state->flow == from_->flow &&
        state->stage != ComparedRun::Stage::start)
      patch = &state->patch;
  if (!patch && from_->kind == DistanceFrom::Kind::flow) return;  // no view has it, or it has not run
  measuring_ = std::make_shared<Job>(this);
  tasks_.run(
      measuring_,
      [job = measuring_, states, mesh = from_->mesh, own = patch ? surface_of(*patch) : TriangleSoup()] {
        const DistanceSurface from(mesh.empty() ? own : read_mesh(mesh).soup);
        std::vector<ComparedRunPtr> measured;
        for (const ComparedRunPtr& state : states)
          if (!job->token().cancelled()) measured.push_back(with_distances(*state, from, job->token()));
        return measured;
      },
      [this](std::vector<ComparedRunPtr> measured) {
        measuring_.reset();
        start_ = measured.back();
        measured.pop_back();
        newest_ = std::move(measured);
        Q_EMIT this->measured();
      },
      [this](const QString& text) {
        measuring_.reset();
        from_.reset();
        Q_EMIT failed(text);
      });
}

/// One flow on its worker. Has its own copies of all it reads; the controller only hears of new states.
class ComparisonController::FlowRun {
 public:
  FlowRun(ComparisonController* flow_comparison, int flow_run, EvolutionOptions base, std::shared_ptr<Post> post)
      : flow_comparison_(flow_comparison),
        at_(static_cast<std::size_t>(flow_run)),
        flow_(flow_comparison->flow(flow_run)),
        start_(flow_comparison->start_),
        origin_(flow_comparison->source_.origin),
        base_(std::move(base)),
        job_(flow_comparison->job_),
        post_(std::move(post)) {}

  void go() const {
    const auto on_step = [this](const Evolution& evolution, const StepRecord& record) { show(evolution, record); };
    ComparedFlow run = run_compared(start_->patch, flow_, base_, on_step, job_->token());
    if (job_->token().cancelled()) return;
    show_end(run);
    {
      const std::lock_guard lock(post_->mutex);
      post_->runs[at_] = std::move(run);
      if (++post_->ended < post_->runs.size()) return;
    }
    describe_start(start_->patch, post_->comparison);
    post_->comparison.runs = std::move(post_->runs);
    add_profiles(post_->comparison);
    job_->post([flow_comparison = flow_comparison_, post = post_] { flow_comparison->end(post); });
  }

 private:
  void show(const Evolution& evolution, const StepRecord& record) const {
    if (job_->token().cancelled()) return;
    const PatchEnergies energies = patch_energies(evolution.patch());
    {
      const std::lock_guard lock(post_->mutex);
      post_->points[at_].push_back({record.step, energies});
      if (post_->newest[at_]) return;  // the window has not taken the last one yet: this one would not be seen
    }
    auto state = seen(evolution.patch(), post_->edge, origin_);
    state->stage = ComparedRun::Stage::moving;
    state->steps = record.step;
    state->energies = energies;
    state->status = PatchStatus::ready;
    state->energy = {evolution.initial_energy(), record.energy};
    put(std::move(state));
  }

  void show_end(const ComparedFlow& run) const {
    auto state = seen(run.outcome.patch, post_->edge, origin_);
    static_cast<PatchResult&>(*state) = run.outcome;
    state->stage = ComparedRun::Stage::ended;
    state->energies = run.energies;
    state->wide_jump = run.wide_jump;
    put(std::move(state));
  }

  void put(std::shared_ptr<ComparedRun> state) const {
    state->flow = flow_;
    state->options = options_for(flow_, base_);
    state->seconds.total = seconds_since(began_);
    {
      const std::lock_guard lock(post_->mutex);
      post_->newest[at_] = std::move(state);
      if (std::exchange(post_->waiting, true)) return;
    }
    job_->post([flow_comparison = flow_comparison_, post = post_] { flow_comparison->take_news(post); });
  }

  ComparisonController* flow_comparison_;
  std::size_t at_;
  FlowKind flow_;
  ComparedRunPtr start_;
  Vec3 origin_;
  EvolutionOptions base_;
  JobPtr job_;
  std::shared_ptr<Post> post_;
  Clock::time_point began_ = Clock::now();
};

void ComparisonController::run(const EvolutionOptions& base) {
  if (stage_ != Stage::ready) return;
  drop(measuring_);
  forget_results();
  job_ = std::make_shared<Job>(this);
  auto post = std::make_shared<Post>(flows_.size());
  post->edge = first_edge(start_->patch);
  stage_ = Stage::running;
  Q_EMIT stage_changed();
  for (int flow_run = 0; flow_run < flow_runs(); ++flow_run)
    tasks_.start(
        job_, [work = FlowRun(this, flow_run, base, post)] { work.go(); },
        [this](const QString& words) {
          stop();
          Q_EMIT failed(words);
        });
}

void ComparisonController::take_news(const std::shared_ptr<Post>& post) {
  std::vector<ComparedRunPtr> news;
  std::vector<std::vector<ComparisonPoint>> points;
  {
    const std::lock_guard lock(post->mutex);
    news.assign(post->newest.size(), nullptr);
    points.resize(post->points.size());
    news.swap(post->newest);
    points.swap(post->points);
    post->waiting = false;
  }
  for (std::size_t flow_run = 0; flow_run < news.size(); ++flow_run) {
    curves_[flow_run].insert(curves_[flow_run].end(), points[flow_run].begin(), points[flow_run].end());
    if (!news[flow_run]) continue;
    newest_[flow_run] = news[flow_run];
    Q_EMIT flow_run_moved(static_cast<int>(flow_run));
  }
}

void ComparisonController::end(const std::shared_ptr<Post>& post) {
  take_news(post);
  comparison_ = std::move(post->comparison);
  for (std::size_t flow_run = 0; flow_run < newest_.size() && flow_run < comparison_->profiles.size(); ++flow_run) {
    auto state = std::make_shared<ComparedRun>(*newest_[flow_run]);
    state->profile = comparison_->profiles[flow_run];
    newest_[flow_run] = std::move(state);
  }
  job_.reset();
  stage_ = Stage::ready;
  Q_EMIT stage_changed();
  measure();
}

void ComparisonController::stop() {
  if (stage_ != Stage::running) return;
  drop(job_);
  for (ComparedRunPtr& flow_run : newest_) {
    if (flow_run->stage != ComparedRun::Stage::moving) continue;
    auto state = std::make_shared<ComparedRun>(*flow_run);
    state->stage = ComparedRun::Stage::stopped;
    flow_run = std::move(state);
  }
  stage_ = Stage::ready;
  Q_EMIT stage_changed();
  measure();
}

bool ComparisonController::shut_down(std::chrono::milliseconds at_most) { return tasks_.stop(at_most); }

}  // namespace loopmend
