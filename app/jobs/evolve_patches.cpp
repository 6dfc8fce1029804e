#include "jobs/evolve_patches.h"

#include "analysis/curvature_field.h"

#include <chrono>

namespace loopmend {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int steady_step_limit = 200;

PatchStage stage_of(EvolutionStatus status) {
  switch (status) {
    case EvolutionStatus::converged: return PatchStage::converged;
    case EvolutionStatus::failed: return PatchStage::failed;
    default: return PatchStage::stepped;
  }
}

/// One patch under way.
class Runner {
 public:
  Runner(const EvolveTask& task, const EvolveTask::Item& item, const std::function<void(int, PatchStatePtr)>& show)
      : id_(item.patch_id),
        state_(item.start),
        show_(show),
        origin_(task.origin),
        started_(Clock::now()) {
    if (item.session) {
      evolution_ = item.session;
      evolution_->set_options(task.options);
    } else {
      evolution_ = std::make_shared<Evolution>(item.start->patch, task.options);
    }
    initial_energy_ = evolution_->energy();
  }

  bool at_rest() const { return at_rest_; }

  void step(const CancelToken& cancel) {
    const std::size_t before = evolution_->history().size();
    evolution_->step(cancel);
    if (cancel.cancelled()) return;
    const bool moved = evolution_->history().size() > before;
    const EvolutionStatus status = evolution_->status();
    at_rest_ = !moved || status == EvolutionStatus::converged || status == EvolutionStatus::failed;
    if (moved) {
      publish(*evolution_, evolution_->history().back());
    } else {
      close();
    }
  }

  EvolutionSession session() const { return {evolution_, state_}; }

 private:
  void publish(const Evolution& evolution, const StepRecord& record) {
    auto next = std::make_shared<PatchState>(*state_);
    next->patch = evolution.patch();
    next->shape = std::make_shared<SurfaceShape>(shape_of(next->patch, curvature_field(next->patch), origin_));
    next->seam = seam_reports(next->patch);
    next->flow = evolution.options().flow;
    next->steps = state_->steps + 1;
    next->last_step = record;
    set_outcome(*next, evolution);
    put(std::move(next));
  }

  /// The run ended without a further step: only stage and words change.
  void close() {
    auto next = std::make_shared<PatchState>(*state_);
    set_outcome(*next, *evolution_);
    put(std::move(next));
  }

  void set_outcome(PatchState& next, const Evolution& evolution) const {
    next.stage = stage_of(evolution.status());
    next.message = evolution.message();
    next.initial_energy = initial_energy_;
    next.seconds = std::chrono::duration<double>(Clock::now() - started_).count();
  }

  void put(PatchStatePtr next) {
    state_ = std::move(next);
    show_(id_, state_);
  }

  int id_;
  PatchStatePtr state_;
  const std::function<void(int, PatchStatePtr)>& show_;
  Vec3 origin_;
  Clock::time_point started_;
  std::shared_ptr<Evolution> evolution_;
  double initial_energy_ = 0;
  bool at_rest_ = false;
};

void drive(std::vector<Runner>& runners, Pace pace, const Job& job) {
  const CancelToken& cancel = job.token();
  const auto stop = [&] { return cancel.cancelled() || job.asked_to_pause(); };
  if (pace == Pace::steady) {
    for (Runner& runner : runners)
      for (int i = 0; i < steady_step_limit && !runner.at_rest() && !stop(); ++i) runner.step(cancel);
    return;
  }
  bool moving = true;
  while (moving && !stop()) {
    moving = false;
    for (Runner& runner : runners) {
      if (stop()) return;
      if (runner.at_rest()) continue;
      runner.step(cancel);
      moving = moving || !runner.at_rest();
    }
    if (pace == Pace::one_step) return;
  }
}

}  // namespace

EvolveResult evolve_patches(const EvolveTask& task, const std::function<void(int, PatchStatePtr)>& show,
                            const Job& job) {
  EvolveResult result;
  std::vector<Runner> runners;
  std::vector<int> ids;
  for (const EvolveTask::Item& item : task.items) {
    if (job.token().cancelled()) return result;
    try {
      runners.emplace_back(task, item, show);
      ids.push_back(item.patch_id);
    } catch (const std::exception& error) {
      result.failures.emplace_back(item.patch_id, error.what());
    }
  }
  drive(runners, task.pace, job);
  for (std::size_t i = 0; i < runners.size(); ++i) result.sessions.emplace_back(ids[i], runners[i].session());
  return result;
}

}  // namespace loopmend
