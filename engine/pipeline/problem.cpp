// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/problem.h"

#include "core/error.h"
#include "mesh/join_parts.h"
#include "mesh/validity.h"
#include "pipeline/append_colored_patch.h"
#include "pipeline/blend.h"
#include "pipeline/interpolate.h"

namespace loopmend {

namespace {

/// The patch pasted into the model.
std::function<TriangleSoup(const Patch&)> pasting(ModelPtr model) {
  return [model = std::move(model)](const Patch& evolved) {
    SurfaceModel whole = *model;
    append_colored_patch(whole, patch_geometry(evolved));
    return whole.soup;
  };
}

Solution blended(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, const GroupOptions& options,
                 const Evolution::OnStep& on_step, const CancelToken& cancel) {
  SurfaceModel joined = model;
  Solution solution;
  solution.outcome = blend_loops(joined, loops, options, cancel, on_step).outcome;
  if (cancel.cancelled()) return solution;
  if (solution.outcome.status == PatchStatus::failed)
    solution.refusal = solution.outcome.message;
  else
    solution.surface = std::move(joined.soup);
  return solution;
}

}  // namespace

PosedProblem pose_region(const ModelPtr& model, const std::vector<int>& vertices) {
  const auto region = std::make_shared<const Region>(make_region(*model, vertices));
  PosedProblem posed;
  posed.problem = {region->patch,
                   [model, region](const Patch& evolved) { return with_region(*model, *region, evolved); }};
  posed.replaced = region->own_triangle;
  if (region->held_at_boundary > 0)
    posed.remark = say("%1 vertices of the region lie on the surface's boundary: they stay", region->held_at_boundary);
  posed.solve = [model, region](const EvolutionOptions& options, const Evolution::OnStep& on_step,
                                const CancelToken& cancel) {
    Solution solution{{}, evolve_region(*region, options, on_step, cancel), {}};
    if (cancel.cancelled()) return solution;
    solution.refusal = refusal_of(*region, solution.outcome);
    if (solution.refusal.empty()) solution.surface = with_region(*model, *region, solution.outcome.patch);
    return solution;
  };
  return posed;
}

PosedProblem pose_points(const ModelPtr& polyhedron, const SubdivisionOptions& options) {
  const auto start = std::make_shared<const PolyhedronPatch>(subdivide_polyhedron(*polyhedron, options));
  PosedProblem posed;
  posed.problem = {start->patch, [start](const Patch& evolved) { return polyhedron_surface(*start, evolved); }};
  posed.solve = [polyhedron, options](const EvolutionOptions& evolution, const Evolution::OnStep& on_step,
                                      const CancelToken& cancel) {
    Interpolation result = interpolate_points(*polyhedron, options, evolution, cancel, on_step);
    Solution solution{{}, std::move(result.outcome), {}};
    if (cancel.cancelled()) return solution;
    solution.refusal = refusal_of(solution.outcome);
    if (solution.refusal.empty()) solution.surface = std::move(result.surface);
    return solution;
  };
  return posed;
}

PosedProblem pose_bridge(const ModelPtr& model, const std::vector<BoundaryLoop>& loops,
                         const InitialPatchOptions& options, const CancelToken& cancel) {
  SurfaceModel agreed = *model;
  std::vector<BoundaryLoop> ends = loops;
  const std::size_t turned = turn_opposed_pieces(agreed, ends, find_opposed_loops(agreed, ends));
  BridgeOutcome outcome = bridge_loops(agreed, ends, options, cancel);
  if (!outcome.bridge) throw InvalidArgument(say("the loops were not joined: %1", outcome.message));
  PosedProblem posed;
  posed.problem = {std::move(outcome.bridge->start), pasting(std::make_shared<const SurfaceModel>(std::move(agreed)))};
  if (turned > 0) posed.remark = say("%1 faces were turned round: their inside faced the gap", turned);
  posed.solve = [model, loops, options](const EvolutionOptions& evolution, const Evolution::OnStep& on_step,
                                        const CancelToken& token) {
    return blended(*model, loops, {options, evolution}, on_step, token);
  };
  return posed;
}

PosedProblem pose_holes(const ModelPtr& model, const std::vector<BoundaryLoop>& holes,
                        const InitialPatchOptions& options, const CancelToken& cancel) {
  InitialPatch initial = make_initial_patch(*model, holes, options, cancel);
  if (!initial.patch)
    throw InvalidArgument(joined(say("no hole could be filled"), ": ",
                                 initial.outcomes.empty() ? Message() : initial.outcomes.front().message));
  PosedProblem posed;
  posed.problem = {std::move(*initial.patch), pasting(model)};
  return posed;
}

}  // namespace loopmend
