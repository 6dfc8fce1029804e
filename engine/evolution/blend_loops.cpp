// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/blend_loops.h"

#include "evolution/evolve_filler.h"
#include "evolution/patch_verdict.h"
#include "mesh/join_parts.h"
#include "mesh/quality.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

namespace loopmend {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void take_evolved(Evolved evolved, FlowKind flow, BlendResult& result) {
  result.patch = std::move(evolved.patch);
  result.status = evolved.status;
  result.method = method_name(evolved.method, flow);
  result.reason = std::move(evolved.reason);
  result.message = std::move(evolved.message);
  result.steps = evolved.steps;
  result.bending = evolved.bending;
  result.energy = {evolved.initial_energy, evolved.final_energy};
  result.seconds.assemble = evolved.assemble;
  result.seconds.solve = evolved.solve;
}

/// Where tubes bend sharply ∫‖∇H‖² seems to prefer two bubbles with a neck that grows ever thinner: the flow reaches its step
/// limit. Of the shares that were tried the least that kept the neck open.
constexpr double against_necks = 5;

Evolved evolve_bridge(const FillSite& site, const Patch& start, const EvolutionOptions& options,
                      const Evolution::OnStep& on_step, const CancelToken& cancel) {
  Evolved pure = evolve_filler(site, start, {}, options, on_step, cancel);
  const bool may_bend = options.flow == FlowKind::mmcvf && options.mode == EvolutionMode::steady && !options.bending;
  const bool good = pure.status != LoopStatus::step_limit && pure.status != LoopStatus::doubtful;
  if (good || !may_bend || cancel.cancelled()) return pure;
  EvolutionOptions stiffer = options;
  stiffer.bending = against_necks;
  Evolved bent = evolve_filler(site, start, {}, stiffer, on_step, cancel);
  if (bent.status != LoopStatus::converged || bent.verdict.folds > 0 || bent.verdict.total() > 0) return pure;
  bent.reason = pure.status == LoopStatus::doubtful
                    ? "the patch of the flow itself was out of proportion; with bending energy mixed in it is not"
                    : "the flow itself did not converge; with bending energy mixed in it did";
  return bent;
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
  result.method.clear();
  result.reason.clear();
  result.patch.reset();
}

constexpr double visible_angle = 5;  ///< degrees at a seam: a crease that the eye sees

/// The patch is meant to leave its surroundings without a crease; where it does not, that is told.
void tell_of_creases(const EvolutionOptions& options, BlendResult& result) {
  if (options.flow != FlowKind::mmcvf || options.continuity == SeamContinuity::position) return;
  double worst = 0;
  for (const SeamReport& seam : result.seams_after) worst = std::max(worst, seam.g1_rms_deg);
  if (!(worst > visible_angle)) return;
  if (!result.message.empty()) result.message += "; ";
  result.message += "a crease of " + std::to_string(std::lround(worst)) +
                    " degrees is left at a seam: the patch turns too sharply there for edges of this length; finer "
                    "meshes would help";
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
    take_evolved(evolve_bridge(site, result.bridge->start, *options.evolution, on_step, cancel),
                 options.evolution->flow, result);
  } else {
    result.patch = result.bridge->membrane;
    result.status = LoopStatus::filled;
    result.method = method_name(Method::initial_patch, FlowKind::mmcvf);
  }
  if (!result.patch || cancel.cancelled()) return result;
  take_verdict(site, result);
  result.seconds.total = seconds_since(begin);
  if (!result.patch) return result;
  result.seams_before = seam_reports(result.bridge->membrane);
  result.seams_after = seam_reports(*result.patch);
  if (options.evolution) tell_of_creases(*options.evolution, result);
  append_patch(agreed, patch_geometry(*result.patch));
  model = std::move(agreed);
  return result;
}

}  // namespace loopmend
