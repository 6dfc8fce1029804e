// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/first_fairing.h"

#include "filling/fairing.h"
#include "filling/loop_filler.h"
#include "filling/patch_remesh.h"

namespace loopmend {

namespace {

constexpr double most_vertices = 1200;  ///< expected: above, most patches have a better start (coarse_patch.h)

/// With edges of the target length all over: those of the coarse mesh are longer inside.
Patch brought_to_size(const Patch& patch) {
  GuardedMesh mesh = open_for_remeshing(patch);
  if (remesh_once(mesh)) remesh_once(mesh);
  return with_interior(patch, mesh);
}

}  // namespace

bool begins_with_fairing(const EvolutionOptions& options) {
  return options.flow == FlowKind::mmcvf && options.mode == EvolutionMode::steady &&
         options.start == SteadyStart::faired && options.triangles == PatchTriangles::free &&
         options.continuity == SeamContinuity::curvature && options.rim != RimTrust::smooth;
}

bool has_first_fairing(const std::vector<BoundaryLoop>& loops, double density, const EvolutionOptions& options) {
  if (loops.size() != 1 || !begins_with_fairing(options)) return false;
  const BoundaryLoop& loop = loops.front();
  const double edge = loop.perimeter / (loop.edges() * density);
  return loop.area < most_vertices * 0.866 * edge * edge;
}

FairedPatch fair_from_coarse(const SurfaceModel& model, const BoundaryLoop& loop, const LoopFiller& coarse,
                             double density, const CancelToken& cancel) {
  Patch patch = make_patch(model, {loop}, {coarse});
  patch.grading.density = density;
  patch.positions = linear_fairing(patch, 0, robust_clamp);
  patch = brought_to_size(patch);
  const auto topology = std::make_shared<Topology>(patch.vertex_count(), patch.triangles);
  return linearly_faired(patch, topology, 0, FairingMesh::kept, SteadyStart::faired, cancel);
}

std::shared_ptr<FirstFairing> first_fairing_of(const SurfaceModel& model, const BoundaryLoop& loop, double density,
                                               const CancelToken& cancel) {
  return std::make_shared<FirstFairing>([=, &model]() -> std::optional<FairedPatch> {
    std::optional<LoopFiller> coarse;
    fill_loop(model, loop, {density}, cancel, [&](const LoopFiller& filler) { coarse = filler; });
    if (!coarse || cancel.cancelled()) return std::nullopt;
    return fair_from_coarse(model, loop, *coarse, density, cancel);
  });
}

}  // namespace loopmend
