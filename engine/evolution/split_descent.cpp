// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/split_descent.h"

#include "evolution/multilevel.h"
#include "evolution/robust_fairing.h"
#include "evolution/stopwatch.h"

#include <algorithm>
#include <utility>

namespace loopmend {

namespace {

/// Height of relief and noise, in boundary edges, up to which the flow itself leads nearer than the fairings do: 3e-3 D
/// against 1e-4 D on half a sphere, where the descent stops short. No difference on the mean of 945 cut holes.
constexpr double nearly_exact = 1e-3;
constexpr const char* descent_stalled_text =
    text_to_say("stopped early: no step lowers the energy of the split any further");

double largest_move(const Patch& before, const Points& after) {
  double move = 0;
  for (int i = 0; i < before.free_count; ++i) move = std::max(move, (after[i] - before.positions[i]).norm());
  return move;
}

}  // namespace

SplitDescent::SplitDescent(const EvolvingPatch& patch, const SplitEstimate& estimate, double radius)
    : estimate_(estimate),
      radius_(radius) {
  if (patch.options.start == SteadyStart::as_given) return;
  by_flow_ = estimate.is_exact(nearly_exact);
  if (by_flow_)
    approach_ = std::make_unique<Multilevel>(patch, NearConvergence::cubic_fits);
  else
    approach_ = std::make_unique<RobustFairing>(patch, radius);
}

void SplitDescent::approach(EvolvingPatch& patch, const CancelToken& cancel) {
  approach_->step(patch, cancel);
  if (patch.status == PatchStatus::ready || patch.status == PatchStatus::cancelled) return;
  if (patch.status == PatchStatus::stalled && patch.history.empty()) {  // it could not start
    if (!std::exchange(by_flow_, false)) return;
    approach_ = std::make_unique<RobustFairing>(patch, radius_);
  } else {
    approach_.reset();
    approached_ = {patch.status, patch.message};
  }
  patch.stop(PatchStatus::ready);
}

void SplitDescent::step(EvolvingPatch& patch, const CancelToken& cancel) {
  if (approach_) return approach(patch, cancel);
  Stopwatch watch;
  if (!problem_) {
    problem_.emplace(patch.state.patch, estimate_, cancel);
    if (cancel.cancelled()) problem_.reset();  // it may be unfinished
  }
  if (cancel.cancelled()) return patch.stop(PatchStatus::cancelled, say("cancelled"));
  const SplitProblem::Outcome outcome = pays_ ? problem_->step(cancel) : SplitProblem::Outcome::ended;
  pays_ = outcome == SplitProblem::Outcome::moved;
  if (!pays_ && outcome != SplitProblem::Outcome::moved_little) {
    if (!patch.history.empty()) patch.history.back().solve_seconds += watch.lap();
    return end(patch, outcome);
  }
  const Points moved = problem_->patch_positions(cancel);
  if (cancel.cancelled()) return patch.stop(PatchStatus::cancelled, say("cancelled"));
  if (moved.empty())
    return patch.stop(PatchStatus::stalled, say("stopped early: the noise could not be carried into the patch"));
  take(patch, moved, watch.lap());
  ++steps_;
}

/// Where Gauss-Newton has ended, J could still be lowered along its gradient. That is left on purpose: over 128 cut holes it came no
/// closer to the truth.
void SplitDescent::end(EvolvingPatch& patch, SplitProblem::Outcome outcome) const {
  if (outcome == SplitProblem::Outcome::cancelled) return patch.stop(PatchStatus::cancelled, say("cancelled"));
  if (outcome == SplitProblem::Outcome::ended && steps_ > 0) return patch.stop(PatchStatus::early_stop);
  if (steps_ > 0 || patch.history.empty()) return patch.stop(PatchStatus::stalled, say(descent_stalled_text));
  if (approached_.first != PatchStatus::faired) return patch.stop(approached_.first, approached_.second);
  patch.stop(PatchStatus::faired, say("no step of the flow came below its fairings, which were kept"));
}

void SplitDescent::take(EvolvingPatch& patch, const Points& moved, double solve_seconds) {
  Stopwatch watch;
  StepRecord record;
  record.step = static_cast<int>(patch.history.size()) + 1;
  record.solve_seconds = solve_seconds;
  record.factorizations = 1;
  record.max_move = largest_move(patch.state.patch, moved) / patch.edge_length();
  Patch next = patch.state.patch;
  std::copy(moved.begin(), moved.end(), next.positions.begin());
  patch.state = make_state(std::move(next), patch.objective, patch.stencil, patch.state.topology, Fits::curvatures);
  record.energy = patch.energy();
  record.split = problem_->energy();
  record.assemble_seconds = watch.lap();
  patch.history.push_back(record);
}

}  // namespace loopmend
