// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/state_making.h"

#include "pipeline/candidates.h"

namespace loopmend {

Message message_of(const PatchResult& result) {
  Message method;
  switch (result.method) {
    case Method::robust_fairing: method = say("robust fairing in place of the flow"); break;
    case Method::sharp_edges: method = say("sharp edges continued in place of the flow"); break;
    case Method::sphere: method = say("the sphere in place of the flow"); break;
    case Method::straight_base: method = say("a straight wall and a plane base in place of the flow"); break;
    case Method::linear_fairing: method = say("linear fairing in place of the flow"); break;
    case Method::split_flow:
      if (result.reason.empty()) method = say("the flow on the smooth surface under the scan");
      break;
    case Method::mixed_order: method = say("the flow with bending energy mixed in"); break;
    case Method::initial_patch:
    case Method::mirror_image:
    case Method::flow: break;
  }
  return joined(std::move(method), ": ", joined(result.reason, "; ", result.message));
}

std::shared_ptr<PatchState> first_state(const Patch& patch, const PatchRecipe& recipe, const Vec3& origin,
                                        const std::shared_ptr<const std::vector<Color>>& scan_colors) {
  auto state = std::make_shared<PatchState>();
  state->shape = shape_of(patch, origin, scan_colors);
  state->seams = seam_reports(patch);
  state->seams_before = state->seams;
  state->status = PatchStatus::filled;
  state->recipe = recipe;
  state->patch = patch;
  return state;
}

std::shared_ptr<PatchState> with_result(const PatchState& from, const PatchResult& result, RunRecipe run,
                                        const Vec3& origin) {
  auto state = std::make_shared<PatchState>();
  static_cast<PatchResult&>(*state) = result;
  state->history.clear();
  state->message = message_of(result);
  state->shape = shape_of(result.patch, origin, from.shape->scan_colors);
  show_deviation(*state);
  const bool same_holes = result.patch.loop_numbers == from.patch.loop_numbers;
  if (same_holes && state->neighborhood.empty()) state->neighborhood = from.neighborhood;
  if (same_holes) state->seams_before = from.seams_before;
  if (state->seams_before.size() != state->seams.size()) state->seams_before = state->seams;
  if (!result.history.empty()) state->last_step = result.history.back();
  state->steps = from.steps + result.steps;
  state->recipe = from.recipe;
  run.steps = result.steps;
  state->recipe.runs.push_back(run);
  return state;
}

std::shared_ptr<PatchState> with_patch(const PatchState& old, const Patch& patch, const Vec3& origin) {
  auto next = std::make_shared<PatchState>(old);
  next->patch = patch;
  next->shape = shape_of(patch, origin, old.shape->scan_colors);
  next->seams = seam_reports(patch);
  next->verdicts.clear();
  next->deviation = {};
  return next;
}

PatchStatePtr judged(PatchStatePtr state, const Patch* initial, ScanContext& scan_context) {
  const Validity validity = validate(scan_context.index(), state->patch);
  const bool cuts = validity.intersections > 0;
  const bool worse = initial && !no_worse(validity, validate(scan_context.index(), *initial));
  if (!cuts && !worse) return state;
  auto marked = std::make_shared<PatchState>(*state);
  marked->status = PatchStatus::invalid;
  marked->message =
      cuts ? say("It cuts the surface or itself in %1 places; the command line leaves such a hole open. Run a flow, or "
                 "discard it and try another density.",
                 validity.intersections)
           : say("It folds over itself where the initial patch did not; the command line would keep the initial patch. "
                 "Go back a few steps, or take smaller ones.");
  return marked;
}

PatchStatePtr with_verdicts(PatchStatePtr state, const Patch& initial, const std::vector<BoundaryLoop>& loops,
                            const EvolutionOptions& options, ScanContext& scan_context) {
  if (state->status == PatchStatus::invalid) return state;
  auto judged = std::make_shared<PatchState>(*state);
  judged->validity = validate(scan_context.index(), judged->patch);
  judge_again({scan_context.index(), initial, loops}, options, *judged);
  expect_deviation(options, {}, *judged);
  show_deviation(*judged);
  return judged;
}

}  // namespace loopmend
