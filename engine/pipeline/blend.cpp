// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/blend.h"

#include "core/error.h"

#include "core/seconds_since.h"
#include "mesh/join_parts.h"
#include "pipeline/candidates.h"
#include "pipeline/paste.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace loopmend {

namespace {

/// Where tubes bend sharply ∫‖∇H‖² seems to prefer two bubbles with a neck that grows ever thinner: the flow reaches its step
/// limit. Of the shares that were tried the least that kept the neck open.
constexpr double against_necks = 5;

PatchResult flow_between(const PatchProblem& problem, const EvolutionOptions& options, const Evolution::OnStep& on_step,
                         const CancelToken& cancel) {
  PatchResult pure = solve_patch(problem, options, on_step, cancel);
  const bool may_bend = options.flow == FlowKind::mmcvf && options.mode == EvolutionMode::steady && !options.bending;
  const bool sound = pure.validity.is_clean() && worst(pure.verdicts) != Grade::bad;
  const bool good = (is_at_end(pure.status) && sound) || pure.status == PatchStatus::filled;
  if (good || !may_bend || cancel.cancelled()) return pure;
  EvolutionOptions stiffer = options;
  stiffer.bending = against_necks;
  PatchResult bent = solve_patch(problem, stiffer, on_step, cancel);
  const bool bent_is_sound = bent.validity.is_clean() && worst(bent.verdicts) != Grade::bad;
  if (bent.status != PatchStatus::converged || !bent_is_sound) return pure;
  bent.reason = !sound ? say("the patch of the flow itself had a fault; with bending energy mixed in it has none")
                       : say("the flow itself did not converge; with bending energy mixed in it did");
  bent.attempts.insert(bent.attempts.begin(), pure.attempts.begin(), pure.attempts.end());
  bent.attempts.back() = bent.made_by = text_to_say("mixed order 5");
  return bent;
}

constexpr double visible_angle = 5;  ///< degrees at a seam: a crease that the eye sees

/// The patch is meant to leave its neighborhood without a crease; where it does not, the result says so.
void tell_of_creases(const EvolutionOptions& options, PatchResult& result) {
  if (options.flow != FlowKind::mmcvf || options.continuity == SeamContinuity::position) return;
  double worst = 0;
  for (const SeamReport& seam : result.seams) worst = std::max(worst, seam.g1_rms_deg);
  if (!(worst > visible_angle)) return;
  add_message(
      result,
      say("a crease of %1 degrees is left at a seam: the patch turns too sharply there for edges of this length; "
          "finer meshes would help",
          std::lround(worst))
          .with_code("crease"));
}

/// The ring as it is: creases at its seams are what was asked for.
PatchResult ring_result(const PatchProblem& problem) {
  EvolutionOptions options;
  options.continuity = SeamContinuity::position;
  PatchResult result = initial_result(problem, options.flow);
  judge_again(problem, options, result);
  for (Verdict& verdict : result.verdicts)  // rugged loops have sharp edges; within itself the ring has no folds
    if (verdict.crossings == 0 && verdict.grade == Grade::bad) verdict.grade = Grade::look;
  result.reason = joined(say("both surfaces end at these loops, so that a straight ring joins them"), "; ",
                         say("--boundary exact runs the flow itself"))
                      .with_code("ring");
  return result;
}

PatchResult refused(const Validity& validity) {
  PatchResult result;
  result.validity = validity;
  result.message = nonmanifold_message(validity.nonmanifold_edges);
  if (validity.intersections > 0)
    result.message =
        say("every patch that was found would cut the surface or itself, in %1 places: the loops cannot be joined as "
            "they lie",
            validity.intersections)
            .with_code("every_patch_crosses");
  return result;
}

}  // namespace

PatchResult solve_bridge(const ScanIndex& scan, const Bridge& bridge, const std::optional<EvolutionOptions>& options,
                         const Evolution::OnStep& on_step, const CancelToken& cancel) {
  const std::vector<BoundaryLoop> no_loops;  // the bridge is no initial patch of single loops
  const bool is_ring = bridge.kind == Bridge::Kind::ring && (!options || is_judged(*options));
  const bool flows = options && bridge.start.free_count > 0 && !is_ring;
  const PatchProblem problem{scan, flows ? bridge.start : bridge.membrane, no_loops};
  PatchResult result = is_ring ? ring_result(problem)
                       : flows ? flow_between(problem, *options, on_step, cancel)
                               : initial_result(problem, options ? options->flow : FlowKind::mmcvf);
  if (cancel.cancelled()) return result;
  if (result.validity.intersections > 0 || result.validity.nonmanifold_edges > 0) return refused(result.validity);
  result.seams_before = seam_reports(bridge.membrane);
  result.seams = seam_reports(result.patch);
  if (options && !is_ring) tell_of_creases(*options, result);
  return result;
}

BlendResult blend_loops(SurfaceModel& model, const std::vector<BoundaryLoop>& loops, const GroupOptions& options,
                        const CancelToken& cancel, const Evolution::OnStep& on_step) {
  const auto begin = std::chrono::steady_clock::now();
  if (options.evolution) check(*options.evolution);
  BlendResult blend;
  SurfaceModel agreed = model;
  std::vector<BoundaryLoop> ends = loops;
  blend.turned_faces = turn_opposed_pieces(agreed, ends, find_opposed_loops(agreed, ends));
  BridgeOutcome outcome = bridge_loops(agreed, ends, options.initial, cancel);
  const double bridge_seconds = seconds_since(begin);
  blend.outcome.message = outcome.message;
  blend.bridge = std::move(outcome.bridge);
  if (!blend.bridge || cancel.cancelled()) return blend;
  blend.outcome = solve_bridge(ScanIndex(agreed), *blend.bridge, options.evolution, on_step, cancel);
  blend.outcome.seconds.initial_patch = bridge_seconds;
  blend.outcome.seconds.total = seconds_since(begin);
  if (cancel.cancelled() || blend.outcome.status == PatchStatus::failed) return blend;
  if (blend.outcome.status == PatchStatus::filled && blend.outcome.message.empty())
    blend.outcome.message = outcome.message;
  Message fault = paste_patches(agreed, {&blend.outcome.patch}).front().fault;
  if (!fault.empty()) throw InvalidArgument(std::move(fault));
  check_exterior(model.soup, agreed.soup, blend.turned_faces);
  model = std::move(agreed);
  return blend;
}

}  // namespace loopmend
