#include "evolution/blend_loops.h"

#include "evolution/patch_verdict.h"
#include "mesh/join_parts.h"
#include "mesh/quality.h"

#include <chrono>

namespace loopmend {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// One run of the flow. @returns true if its result is neither folded nor cut more than the start.
bool evolve_once(const FillSite& site, const Patch& start, const EvolutionOptions& options,
                 const Evolution::OnStep& on_step, const CancelToken& cancel, BlendResult& result) {
  Evolution evolution(start, options);
  const EvolutionStatus status = evolution.run(on_step, cancel);
  if (status == EvolutionStatus::cancelled) return false;
  result.message = evolution.message();
  const bool moved = !evolution.history().empty() || status == EvolutionStatus::converged;
  if (!moved || !no_worse(judge(site, evolution.patch()), judge(site, start))) return false;
  result.patch = evolution.patch();
  result.status = status == EvolutionStatus::converged ? LoopStatus::converged : LoopStatus::step_limit;
  result.steps = static_cast<int>(evolution.history().size());
  result.bending = evolution.bending();
  result.energy = {evolution.initial_energy(), evolution.energy()};
  for (const StepRecord& step : evolution.history()) {
    result.seconds.assemble += step.assemble_seconds;
    result.seconds.solve += step.solve_seconds;
  }
  return true;
}

/// The flow from the start; with bending energy blended in where the sixth order alone would spoil the patch; else the
/// start itself, and a message.
void evolve(const FillSite& site, const Patch& start, const EvolutionOptions& options, const Evolution::OnStep& on_step,
            const CancelToken& cancel, BlendResult& result) {
  if (evolve_once(site, start, options, on_step, cancel, result) || cancel.cancelled()) return;
  if (options.flow == FlowKind::mmcvf && options.mode == EvolutionMode::steady && !options.bending)
    for (double bending : {60.0, 300.0}) {
      EvolutionOptions gentler = options;
      gentler.bending = bending;
      if (evolve_once(site, start, gentler, on_step, cancel, result) || cancel.cancelled()) return;
    }
  result.patch = start;
  result.status = LoopStatus::filled;
  result.message = "the flow would have folded the patch or cut the surface: its start was kept";
}

/// The last look before the paste.
void take_verdict(const FillSite& site, BlendResult& result) {
  const Patch& patch = *result.patch;
  const PatchVerdict verdict = judge(site, patch);
  result.quality = {verdict.folds, verdict.total(),
                    min_angle_deg(patch.positions, patch.triangles, patch.patch_triangles)};
  if (verdict.total() == 0) return;
  result.status = LoopStatus::failed;
  result.message = "every patch that was found would cut the surface or itself, in " + std::to_string(verdict.total()) +
                   " places: the loops cannot be joined as they lie";
  result.patch.reset();
}

}  // namespace

BlendResult blend_loops(SurfaceModel& model, const std::vector<BoundaryLoop>& loops, const FillOptions& options,
                        const CancelToken& cancel, const Evolution::OnStep& on_step) {
  const auto begin = std::chrono::steady_clock::now();
  if (options.evolution) check(*options.evolution);
  BlendResult result;
  result.loops = loops;
  SurfaceModel agreed = model;
  std::vector<BoundaryLoop> ends = loops;
  result.turned_faces = turn_opposed_pieces(agreed, ends, find_opposed_loops(agreed, ends));

  BridgeOutcome outcome = bridge_loops(agreed, ends, options.filler, cancel);
  result.seconds.bridge = seconds_since(begin);
  result.message = outcome.message;
  result.bridge = std::move(outcome.bridge);
  if (!result.bridge || cancel.cancelled()) return result;
  const FillSite site(agreed);
  if (options.evolution && result.bridge->start.free_count > 0) {
    evolve(site, result.bridge->start, *options.evolution, on_step, cancel, result);
  } else {
    result.patch = result.bridge->membrane;
    result.status = LoopStatus::filled;
  }
  if (!result.patch || cancel.cancelled()) return result;
  take_verdict(site, result);
  result.seconds.total = seconds_since(begin);
  if (!result.patch) return result;
  result.seams_before = seam_reports(result.bridge->membrane);
  result.seams_after = seam_reports(*result.patch);
  append_patch(agreed, patch_geometry(*result.patch));
  model = std::move(agreed);
  return result;
}

}  // namespace loopmend
