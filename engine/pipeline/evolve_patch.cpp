// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/evolve_patch.h"

#include "filling/fairing.h"
#include "pipeline/multi_start.h"

namespace loopmend {

namespace {

bool is_good(const PatchResult& result) { return result.validity.is_clean() && result.status != PatchStatus::stalled; }

/// Valid before invalid, finished before stalled, then the lower energy.
bool better(const PatchResult& a, const PatchResult& b) {
  if (a.validity.is_clean() != b.validity.is_clean()) return a.validity.is_clean();
  if (is_good(a) != is_good(b)) return is_good(a);
  return a.energy.final < b.energy.final;
}

}  // namespace

PatchResult run_flow(const Patch& start, const EvolutionOptions& options, const Evolution::OnStep& on_step,
                     const CancelToken& cancel) {
  Evolution evolution(start, options);
  PatchResult result;
  result.status = evolution.run(on_step, cancel);
  result.message = evolution.message();
  result.flow = options.flow;
  result.method = evolution.method();
  if (is_judged(options) && evolution.split()) result.reason = reason_for(*evolution.split(), result.method);
  result.patch = evolution.patch();
  result.validity = patch_validity(result.patch);
  take_figures(evolution, result);
  return result;
}

PatchResult evolve_patch(const Patch& start, const EvolutionOptions& options, const Evolution::OnStep& on_step,
                         const CancelToken& cancel) {
  const Validity at_start = patch_validity(start);  // what the patch came with is not the flow's
  const PatchResult result = best_of_starts(
      start, options, cancel,
      [&](const Patch& from, const EvolutionOptions& tried) { return run_flow(from, tried, on_step, cancel); },
      [&](const PatchResult& run) { return rating_of(run, no_worse(run.validity, at_start) && !run.history.empty()); });
  if (is_good(result) || cancel.cancelled()) return result;
  Patch smooth = start;
  smooth.positions = linear_fairing(start, 0, robust_clamp, cancel);
  if (smooth.positions == start.positions) return result;
  PatchResult second = run_flow(smooth, options, on_step, cancel);
  return better(second, result) ? second : result;
}

}  // namespace loopmend
