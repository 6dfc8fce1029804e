// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/threads.h"
#include "evolution/coarse_patch.h"
#include "evolution/evolution_impl.h"
#include "evolution/linear_start.h"
#include "evolution/mesh_care.h"
#include "evolution/stopwatch.h"
#include "mesh/quality.h"
#include "rim/rim_blend.h"

#include <algorithm>
#include <limits>

namespace loopmend {

namespace {

constexpr double room_beyond_fairing = 0.35;
constexpr double least_coarsening = 0.7;       ///< of the free vertices
constexpr std::size_t most_coarse_steps = 12;  ///< straight ways take fewer; a longer one may lead to a bubble

/// How far the middle of the free vertices has come, patch frame: where vertices come and go, the only way to tell.
double way_of_centroid(const Patch& from, const Patch& to) {
  const auto centroid = [](const Patch& patch) {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < patch.free_count; ++i) sum += patch.positions[i];
    return Vec3(sum / patch.free_count);
  };
  return (centroid(from) - centroid(to)).norm();
}

}  // namespace

/// A linear fairing instead of a Gauss-Newton step, while it pays: from its result large openings are reached too.
/// @returns false if that does not lower the energy any more; then the state is as it was.
bool Evolution::Impl::fairing_step(const CancelToken& cancel) {
  const bool worn = state.folds > 0 || edge_length() > 1.05 * start_edge_length ||
                    min_angle_deg(state.patch.positions, state.patch.triangles, state.patch.patch_triangles) < 30;
  const FairingMesh mesh = options.triangles != PatchTriangles::free ? FairingMesh::fixed
                           : worn && !history.empty()                ? FairingMesh::remeshed
                                                                     : FairingMesh::kept;
  FairedPatch faired;
  EvolutionState next;
  const auto fair = [&] {
    faired = linearly_faired(state.patch, state.topology, objective.bending, mesh, options.start, cancel);
    Stopwatch watch;
    next = make_state(std::move(faired.patch), objective, stencil, faired.topology, Fits::curvatures);
    faired.assemble_seconds += watch.lap();
  };
  // Fairings leave the other core half idle, and what comes after them will need the start by cubic fits.
  if (smooth_surroundings && !cubic_start && thread_budget() > 1)
    parallel_invoke(fair, [&] { cubic_start = state_of_start_by_cubic_fits(); });
  else
    fair();
  if (!acceptable(next, state.measure)) return false;
  if (next.measure > 0.5 * state.measure && next.folds == 0) fairings_left = 0;
  StepRecord record;
  record.assemble_seconds = faired.assemble_seconds;
  record.solve_seconds = faired.solve_seconds;
  take_start(std::move(next), record, faired.move);
  // As after a Gauss-Newton step: so near, those steps had better be of the fits that they will end with.
  if (fairings_left == 0 && history.back().max_move < near_move) go_over_to_cubic_fits();
  return true;
}

/// A better start has been found: the way to the steady state goes on from there.
void Evolution::Impl::take_start(EvolutionState next, StepRecord record, double move) {
  state = std::move(next);
  room = room_around(state.patch, room_beyond_fairing);
  record.step = static_cast<int>(history.size()) + 1;
  record.max_move = move / edge_length();
  record.energy = shown_energy(options.flow, state);
  history.push_back(record);
}

/// The steady state of a coarse copy, in place of the linear fairings: near enough for one or two Gauss-Newton steps.
/// @returns false if there was none, or it does not lower the energy; then the state is as it was.
bool Evolution::Impl::coarse_step(const CancelToken& cancel) {
  Stopwatch watch;
  EvolutionOptions coarse_options = options;
  coarse_options.bending = blend;
  coarse_options.roughness = rim;
  Patch copy = coarsened(state.patch);
  // Between tubes there may be nothing to take away; such a copy would ask for a coarse copy of its own, without end.
  if (copy.free_count > least_coarsening * state.patch.free_count) return false;
  Evolution coarse(std::move(copy), coarse_options);
  const Impl& there = *coarse.impl_;
  while (coarse.status() == PatchStatus::ready && there.history.size() < most_coarse_steps && !there.near_the_end())
    coarse.step(cancel);
  StepRecord record;
  record.solve_seconds = watch.lap();
  if (coarse.status() != PatchStatus::converged && !there.near_the_end()) return false;
  EvolutionState next = make_state(refined(there.state, state.patch.grading), objective, there.stencil);
  record.assemble_seconds = watch.lap();
  if (!acceptable(next, state.measure)) return false;
  if (there.stencil != stencil)
    initial_energy = shown_energy(options.flow, make_state(start, objective, there.stencil, nullptr, Fits::curvatures));
  stencil = there.stencil;
  damping_unit = there.damping_unit;
  fairings_left = 0;
  take_start(std::move(next), record, way_of_centroid(there.start, there.state.patch));
  return true;
}

/// One linear fairing of those that are the whole way. The first on rough surroundings is of second order, from which the
/// rim vertices are judged.
void Evolution::Impl::blend_step() {
  Stopwatch watch;
  const bool judged = options.continuity == SeamContinuity::curvature;
  const bool first = judged && blends_left == rough_passes;
  const double R = rim->radius;
  // Where a crease of the start lies between wide angles, negative weights, clamped, would hold it for ever.
  const bool flips = judged && options.triangles != PatchTriangles::fixed;
  const Patch before = flips ? with_delaunay_flips(state.patch) : state.patch;
  const auto topology = before.triangles == state.patch.triangles ? state.topology : nullptr;
  const Eigen::VectorXd trust = judged && !first ? rim_trust(before, R, rim_data_trust) : Eigen::VectorXd();
  Patch patch = before;
  const bool solved =
      first ? blend_once(patch, SeamContinuity::tangent, {}, R) : blend_once(patch, options.continuity, trust, R);
  if (!solved) return stop(PatchStatus::stalled, "stopped early: the patch is too degenerate to be faired");
  StepRecord record;
  record.step = static_cast<int>(history.size()) + 1;
  record.solve_seconds = watch.lap();
  double move = 0;
  for (int i = 0; i < patch.free_count; ++i) move = std::max(move, (patch.positions[i] - before.positions[i]).norm());
  record.max_move = move / edge_length();
  --blends_left;
  state = make_state(std::move(patch), objective, stencil, topology, Fits::curvatures);
  if (state.folds > start_folds && options.triangles == PatchTriangles::free)
    replace_if_good(remeshed(state.patch), std::numeric_limits<double>::max());
  record.energy = shown_energy(options.flow, state);
  record.assemble_seconds = watch.lap();
  history.push_back(record);
  // Fairings of lower order are repeated until they move nothing; on most scans vertices go on sliding along the surface.
  const bool at_rest = !judged && record.max_move < small_move;
  if (blends_left == 0 || at_rest) stop(PatchStatus::faired, "");
}

}  // namespace loopmend
