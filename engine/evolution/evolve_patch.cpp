// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/evolve_patch.h"

#include "evolution/best_start.h"
#include "filling/fairing.h"
#include "filling/patch_quality.h"

namespace loopmend {

namespace {

/// Folds and cuts that the patch came with are not the flow's.
struct Rate {
  FillerQuality start;
  RunRating operator()(const EvolvedPatch& result) const {
    const FillerQuality& now = result.quality;
    const bool valid = now.folds <= start.folds && now.self_intersections <= start.self_intersections;
    const bool at_its_end = result.status == EvolutionStatus::converged || result.status == EvolutionStatus::faired;
    return {valid && !result.history.empty(), at_its_end, !result.history.empty() && result.history.front().sigma == 0,
            result.steps, result.energy.final};
  }
};

bool is_good(const EvolvedPatch& result) { return result.is_valid() && result.status != EvolutionStatus::failed; }

/// Valid before invalid, finished before stalled, then the lower energy.
bool better(const EvolvedPatch& a, const EvolvedPatch& b) {
  if (a.is_valid() != b.is_valid()) return a.is_valid();
  if (is_good(a) != is_good(b)) return is_good(a);
  return a.energy.final < b.energy.final;
}

}  // namespace

EvolvedPatch run_flow(const Patch& start, const EvolutionOptions& options, const Evolution::OnStep& on_step,
                      const CancelToken& cancel) {
  Evolution evolution(start, options);
  EvolvedPatch result;
  result.status = evolution.run(on_step, cancel);
  result.message = evolution.message();
  result.flow = options.flow;
  result.method = evolution.method();
  if (is_judged(options) && result.method != Method::flow && evolution.roughness()) {
    RimRoughness boundary = *evolution.roughness();
    if (result.method == Method::robust_fairing) boundary.rough_share = 1;  // here there is nothing in between
    result.reason = reason_for(boundary);
  }
  result.patch = evolution.patch();
  result.quality = patch_quality(result.patch);
  result.history = evolution.history();
  result.steps = static_cast<int>(result.history.size());
  result.bending = evolution.bending();
  result.energy = {evolution.initial_energy(), evolution.energy()};
  for (const StepRecord& step : result.history) {
    result.seconds.assemble += step.assemble_seconds;
    result.seconds.solve += step.solve_seconds;
  }
  return result;
}

EvolvedPatch evolve_patch(const Patch& start, const EvolutionOptions& options, const Evolution::OnStep& on_step,
                          const CancelToken& cancel) {
  const EvolvedPatch result = best_of_starts(
      start, options, cancel,
      [&](const Patch& from, const EvolutionOptions& tried) { return run_flow(from, tried, on_step, cancel); },
      Rate{patch_quality(start)});
  if (is_good(result) || cancel.cancelled()) return result;
  Patch smooth = start;
  smooth.positions = linear_fairing(start, 0, robust_clamp);
  if (smooth.positions == start.positions) return result;
  EvolvedPatch second = run_flow(smooth, options, on_step, cancel);
  return better(second, result) ? second : result;
}

}  // namespace loopmend
