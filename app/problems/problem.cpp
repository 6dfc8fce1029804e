// SPDX-License-Identifier: GPL-3.0-or-later
#include "problems/problem.h"

#include "core/error.h"
#include "evolution/blend_loops.h"
#include "filling/patch_quality.h"
#include "mesh/join_parts.h"

namespace loopmend {

namespace {

/// The patch pasted into the model.
std::function<TriangleSoup(const Patch&)> pasting(ModelPtr model) {
  return [model = std::move(model)](const Patch& evolved) {
    SurfaceModel whole = *model;
    append_patch(whole, patch_geometry(evolved));
    return whole.soup;
  };
}

Solution solution_of(const EvolvedPatch& evolved) {
  Solution solution;
  solution.patch = evolved.patch;
  solution.status = evolved.status;
  solution.message = evolved.message;
  solution.method = method_name(evolved.method, evolved.flow);
  solution.steps = evolved.steps;
  solution.initial_energy = evolved.energy.initial;
  solution.final_energy = evolved.energy.final;
  return solution;
}

std::string flaws(const FillerQuality& quality) {
  return std::to_string(quality.folds) + " folded edges and " + std::to_string(quality.self_intersections) +
         " self-intersections";
}

EvolutionStatus status_of(LoopStatus status) {
  switch (status) {
    case LoopStatus::converged: return EvolutionStatus::converged;
    case LoopStatus::faired: return EvolutionStatus::faired;
    case LoopStatus::doubtful:
    case LoopStatus::step_limit: return EvolutionStatus::step_limit;
    default: return EvolutionStatus::failed;
  }
}

Solution solve_bridge(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, const FillOptions& options,
                      const Evolution::OnStep& on_step, const CancelToken& cancel) {
  SurfaceModel joined = model;
  const BlendResult result = blend_loops(joined, loops, options, cancel, on_step);
  Solution solution;
  if (cancel.cancelled()) return solution;
  solution.status = status_of(result.status);
  solution.message = result.message;
  solution.method = result.method;
  if (!result.patch) {
    solution.refusal = result.message;
    return solution;
  }
  solution.patch = *result.patch;
  solution.steps = result.steps;
  solution.initial_energy = result.energy.initial;
  solution.final_energy = result.energy.final;
  solution.surface = std::move(joined.soup);
  return solution;
}

}  // namespace

EvolvedPatch evolve_region(const Region& region, EvolutionOptions options, const Evolution::OnStep& on_step,
                           const CancelToken& cancel) {
  options.triangles = PatchTriangles::kept;  // the file's numbering is to stay
  return evolve_patch(region.patch, options, on_step, cancel);
}

std::string refusal_of(const Region& region, const EvolvedPatch& evolved) {
  const FillerQuality before = patch_quality(region.patch);
  const bool worse =
      evolved.quality.folds > before.folds || evolved.quality.self_intersections > before.self_intersections;
  return worse ? "the flow would leave " + flaws(evolved.quality) + " in the region" : std::string();
}

PosedProblem pose_region(const ModelPtr& model, const std::vector<int>& vertices) {
  const auto region = std::make_shared<const Region>(make_region(*model, vertices));
  PosedProblem posed;
  posed.problem = {region->patch,
                   [model, region](const Patch& evolved) { return with_region(*model, *region, evolved); }};
  posed.replaced = region->own_triangle;
  if (region->held_at_boundary > 0)
    posed.remark =
        std::to_string(region->held_at_boundary) + " vertices of the region lie on the surface's boundary: they stay";
  posed.solve = [model, region](const EvolutionOptions& options, const Evolution::OnStep& on_step,
                                const CancelToken& cancel) {
    const EvolvedPatch evolved = evolve_region(*region, options, on_step, cancel);
    Solution solution = solution_of(evolved);
    if (cancel.cancelled()) return solution;
    solution.refusal = refusal_of(*region, evolved);
    if (solution.refusal.empty()) solution.surface = with_region(*model, *region, evolved.patch);
    return solution;
  };
  return posed;
}

std::string refusal_of(const Interpolation& result) {
  if (result.evolved.is_valid()) return {};
  return "no valid surface was found: the best one has " + flaws(result.evolved.quality);
}

PosedProblem pose_points(const ModelPtr& polyhedron, const SubdivisionOptions& options) {
  const auto start = std::make_shared<const PolyhedronPatch>(subdivide_polyhedron(*polyhedron, options));
  PosedProblem posed;
  posed.problem = {start->patch, [start](const Patch& evolved) { return polyhedron_surface(*start, evolved); }};
  posed.solve = [polyhedron, options](const EvolutionOptions& evolution, const Evolution::OnStep& on_step,
                                      const CancelToken& cancel) {
    Interpolation result = interpolate_points(*polyhedron, options, evolution, cancel, on_step);
    Solution solution = solution_of(result.evolved);
    if (cancel.cancelled()) return solution;
    solution.refusal = refusal_of(result);
    if (solution.refusal.empty()) solution.surface = std::move(result.surface);
    return solution;
  };
  return posed;
}

PosedProblem pose_bridge(const ModelPtr& model, const std::vector<BoundaryLoop>& loops, const FillerOptions& options,
                         const CancelToken& cancel) {
  SurfaceModel agreed = *model;
  std::vector<BoundaryLoop> ends = loops;
  const std::size_t turned = turn_opposed_pieces(agreed, ends, find_opposed_loops(agreed, ends));
  BridgeOutcome outcome = bridge_loops(agreed, ends, options, cancel);
  if (!outcome.bridge) throw InvalidArgument("the loops were not joined: " + outcome.message);
  PosedProblem posed;
  posed.problem = {std::move(outcome.bridge->start), pasting(std::make_shared<const SurfaceModel>(std::move(agreed)))};
  if (turned > 0) posed.remark = std::to_string(turned) + " faces were turned round: their inside faced the gap";
  posed.solve = [model, loops, options](const EvolutionOptions& evolution, const Evolution::OnStep& on_step,
                                        const CancelToken& token) {
    FillOptions fill;
    fill.filler = options;
    fill.evolution = evolution;
    return solve_bridge(*model, loops, fill, on_step, token);
  };
  return posed;
}

PosedProblem pose_holes(const ModelPtr& model, const std::vector<BoundaryLoop>& holes, const FillerOptions& options,
                        const CancelToken& cancel) {
  PatchStart start = start_patch(*model, holes, options, cancel);
  if (!start.patch)
    throw InvalidArgument("no hole could be filled" +
                          (start.fillers.empty() ? std::string() : ": " + start.fillers.front().message));
  PosedProblem posed;
  posed.problem = {std::move(*start.patch), pasting(model)};
  return posed;
}

}  // namespace loopmend
