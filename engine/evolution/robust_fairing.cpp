// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/robust_fairing.h"

#include "evolution/mesh_improvement.h"
#include "evolution/stopwatch.h"
#include "neighborhood/weighted_fairing.h"

#include <algorithm>
#include <limits>

namespace loopmend {

namespace {

constexpr int robust_passes = 3;  ///< one of second order, two that weigh the boundary data
constexpr int most_passes = 12;   ///< for position or tangent

Eigen::VectorXd confidence_of(const EvolvingPatch& evolving, double radius) {
  const Patch& patch = evolving.state.patch;
  return evolving.options.fits ? data_confidence(patch, radius, *evolving.options.fits)
                               : data_confidence(patch, radius);
}

}  // namespace

RobustFairing::RobustFairing(const EvolvingPatch& patch, double radius)
    : weighs_boundary_(patch.options.continuity == SeamContinuity::curvature),
      radius_(radius),
      data_confidence_(weighs_boundary_ ? confidence_of(patch, radius) : Eigen::VectorXd()),
      passes_left_(weighs_boundary_ ? robust_passes : most_passes) {}

/// One fairing. The first in a rough neighborhood is of second order; from its result the boundary vertices are weighed.
void RobustFairing::step(EvolvingPatch& patch, const CancelToken& cancel) {
  Stopwatch watch;
  const bool first = weighs_boundary_ && passes_left_ == robust_passes;
  // Where a crease of the start lies between wide angles, negative weights, clamped, would hold it for ever.
  const bool flips = weighs_boundary_ && patch.options.triangles != PatchTriangles::fixed;
  const Patch before = flips ? with_delaunay_flips(patch.state.patch) : patch.state.patch;
  const auto topology = before.triangles == patch.state.patch.triangles ? patch.state.topology : nullptr;
  Eigen::VectorXd confidence;
  if (weighs_boundary_ && !first) confidence = confidence_weights(before, radius_, data_confidence_);
  Patch faired = before;
  if (!blend_once(faired, first ? SeamContinuity::tangent : patch.options.continuity, confidence, radius_, cancel)) {
    if (patch.stop_if(cancel)) return;
    return patch.stop(PatchStatus::stalled, say("stopped early: the patch is too degenerate to be faired"));
  }
  StepRecord record;
  record.step = static_cast<int>(patch.history.size()) + 1;
  record.solve_seconds = watch.lap();
  double move = 0;
  for (int i = 0; i < faired.free_count; ++i) move = std::max(move, (faired.positions[i] - before.positions[i]).norm());
  record.max_move = move / patch.edge_length();
  patch.state = make_state(std::move(faired), patch.objective, patch.stencil, topology, Fits::curvatures);
  if (patch.state.folds > patch.start_folds && patch.options.triangles == PatchTriangles::free)
    patch.replace_if_good(remeshed(patch.state.patch), std::numeric_limits<double>::max());
  record.energy = patch.energy();
  record.assemble_seconds = watch.lap();
  patch.history.push_back(record);
  // Fairings of lower order are repeated until they move nothing; on most scans vertices go on sliding along the surface.
  const bool converged = !weighs_boundary_ && record.max_move < small_move;
  if (--passes_left_ == 0 || converged) patch.stop(PatchStatus::faired);
}

}  // namespace loopmend
