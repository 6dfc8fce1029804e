// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/interpolate.h"

#include "filling/fairing.h"
#include "filling/rounded_polyhedron.h"
#include "mesh/validity.h"
#include "pipeline/evolve_patch.h"
#include "pipeline/evolve_region.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace loopmend {

namespace {

constexpr int coarsest = 2;  ///< 4² triangles each: the fewest in which a face can bulge

void add_effort(const PatchResult& before, PatchResult& after) {
  after.steps += before.steps;
  after.seconds.assemble += before.seconds.assemble;
  after.seconds.solve += before.seconds.solve;
  after.history.insert(after.history.begin(), before.history.begin(), before.history.end());
}

/// What a flow from there would start with: few folds first, then little energy.
std::pair<int, double> promise_of(const Patch& patch, const EvolutionOptions& options) {
  return {patch_validity(patch).folds, Evolution(patch, options).energy()};
}

/// The rounded polyhedron where it promises more than flat faces do, faired or not.
Patch first_start(const PolyhedronPatch& level, const EvolutionOptions& options, const CancelToken& cancel) {
  const bool to_the_end = options.flow == FlowKind::mmcvf && options.mode == EvolutionMode::steady;
  if (!to_the_end || level.subdivisions < coarsest) return level.patch;
  const std::optional<Patch> rounded = rounded_polyhedron(level);
  if (!rounded) return level.patch;
  Patch faired = level.patch;
  faired.positions = linear_fairing(level.patch, 0, robust_clamp, cancel);
  const auto flat = std::min(promise_of(level.patch, options), promise_of(faired, options));
  return promise_of(*rounded, options) < flat ? *rounded : level.patch;
}

}  // namespace

Interpolation interpolate_points(const SurfaceModel& polyhedron, const SubdivisionOptions& subdivision,
                                 const std::optional<EvolutionOptions>& evolution, const CancelToken& cancel,
                                 const Evolution::OnStep& on_step) {
  Interpolation result;
  const PolyhedronPatch finest = subdivide_polyhedron(polyhedron, subdivision);
  result.initial = polyhedron_surface(finest, finest.patch);
  result.fixed_count = static_cast<int>(finest.fixed.size());
  result.surface = result.initial;
  result.outcome.patch = finest.patch;
  if (!evolution) {
    result.outcome.status = PatchStatus::filled;
    result.outcome.validity = patch_validity(finest.patch);
    return result;
  }
  SubdivisionOptions coarse = subdivision;
  coarse.subdivisions = std::min(coarsest, subdivision.subdivisions);
  PolyhedronPatch level = subdivide_polyhedron(polyhedron, coarse);
  EvolutionOptions options = *evolution;
  options.triangles = PatchTriangles::kept;  // the subdivision was asked for
  result.outcome = evolve_patch(first_start(level, options, cancel), options, on_step, cancel);
  for (int k = coarse.subdivisions; k < subdivision.subdivisions && !cancel.cancelled(); ++k) {
    level = split_further(level, result.outcome.patch);
    PatchResult finer = evolve_patch(level.patch, options, on_step, cancel);
    add_effort(result.outcome, finer);
    result.outcome = std::move(finer);
  }
  // On the way the fits became finer: the start is measured by those of the end.
  if (subdivision.subdivisions > coarse.subdivisions && !cancel.cancelled())
    result.outcome.energy.initial = Evolution(finest.patch, options).energy();
  result.surface = polyhedron_surface(level, result.outcome.patch);
  result.fixed_count = static_cast<int>(level.fixed.size());
  return result;
}

Message refusal_of(const PatchResult& interpolated) {
  if (interpolated.validity.is_clean()) return {};
  return say("no valid surface was found: the best one has %1", flaws_of(interpolated.validity));
}

}  // namespace loopmend
