// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/evolving_patch.h"

#include "core/error.h"
#include "evolution/mesh_improvement.h"
#include "mesh/quality.h"

#include <algorithm>
#include <cmath>

namespace loopmend {

namespace {

constexpr double room_beyond_start = 1, room_beyond_fairing = 0.35;  ///< on all sides, in diagonals of the patch's box
constexpr int steps_with_mesh_improvement = 15;
constexpr double move_worth_improvement = 0.05;  ///< in mean edge lengths

/// The box of the patch, grown by a share of its diagonal.
Eigen::AlignedBox3d room_around(const Patch& patch, double share) {
  Eigen::AlignedBox3d box;
  for (int i = 0; i < patch.free_count; ++i) box.extend(patch.positions[i]);
  for (const auto& loop : patch.loops)
    for (int v : loop) box.extend(patch.positions[v]);
  const Vec3 margin = Vec3::Constant(share * box.diagonal().norm());
  return {box.min() - margin, box.max() + margin};
}

/// Power of length that the flow's time has: tau in mesh units = tau in the frame × scale^order.
int order_of(FlowKind flow) { return flow == FlowKind::mcf ? 2 : flow == FlowKind::mmcvf ? 6 : 4; }

}  // namespace

EvolvingPatch::EvolvingPatch(Patch first) : start(std::move(first)) {
  if (start.free_count == 0) throw InvalidArgument(say("the patch has no free vertex to evolve"));
  for (const Vec3& p : start.positions)
    if (!p.allFinite()) throw InvalidArgument(say("the patch has a vertex that is not finite"));
  room = room_around(start, room_beyond_start);
  state = make_state(start, objective, stencil, nullptr, Fits::curvatures);
  start_folds = state.folds;
}

void EvolvingPatch::begin(const EvolutionOptions& new_options, const Objective& new_objective) {
  options = new_options;
  objective = new_objective;
  stencil = Stencil::two_ring;
  if (!history.empty() || objective.flow != FlowKind::mmcvf || objective.bending > 0)
    state = make_state(std::move(state.patch), objective, stencil, state.topology, Fits::curvatures);
  const bool steps = options.mode == EvolutionMode::steps || options.flow != FlowKind::mmcvf;
  allowed_folds = start_folds + (steps ? 0 : std::max(2, state.patch.free_count / 200));
  stop(PatchStatus::ready);
}

bool EvolvingPatch::acceptable(const EvolutionState& next, double limit) const {
  if (!std::isfinite(next.measure) || next.folds > std::max(state.folds, allowed_folds)) return false;
  if (next.unfitted > state.unfitted || next.missing > state.missing) return false;  // it would lower the energy
  for (int i = 0; i < next.patch.free_count; ++i)
    if (!room.contains(next.patch.positions[i])) return false;
  return next.measure <= limit;
}

void EvolvingPatch::accept(EvolutionState next, StepRecord record, const Eigen::VectorXd& s, double sigma,
                           double rate) {
  record.step = static_cast<int>(history.size()) + 1;
  record.max_move = s.cwiseAbs().maxCoeff() / edge_length();
  record.sigma = sigma;
  record.tau = sigma / rate * std::pow(state.patch.scale, order_of(options.flow));
  state = std::move(next);
  record.energy = energy();
  history.push_back(record);
}

void EvolvingPatch::accept_start(EvolutionState next, StepRecord record, double move) {
  state = std::move(next);
  room = room_around(state.patch, room_beyond_fairing);
  record.step = static_cast<int>(history.size()) + 1;
  record.max_move = move / edge_length();
  record.energy = energy();
  history.push_back(record);
}

bool EvolvingPatch::replace_if_good(Patch patch, double limit) {
  EvolutionState next = make_state(std::move(patch), objective, stencil);
  if (next.folds > state.folds || next.unfitted > state.unfitted || !(next.measure <= limit)) return false;
  state = std::move(next);
  return true;
}

void EvolvingPatch::improve_mesh(double limit) {
  if (history.size() > steps_with_mesh_improvement || history.back().max_move < move_worth_improvement) return;
  const Patch relaxed = tangentially_relaxed(state);
  if (!replace_if_good(with_delaunay_flips(relaxed), limit)) {
    replace_if_good(relaxed, limit);
    replace_if_good(with_delaunay_flips(state.patch), limit);
  }
  if (state.folds > 0) {
    EvolutionState next = make_state(remeshed(state.patch), objective, stencil);
    if (next.folds < state.folds && next.unfitted <= state.unfitted && std::isfinite(next.measure))
      state = std::move(next);
  }
  history.back().energy = energy();
}

bool EvolvingPatch::require_fits() {
  int loop = 0, known = 0;
  for (int i = state.patch.free_count; i < state.patch.vertex_count() && state.patch.ring[i] == 1; ++i) {
    ++loop;
    known += state.ops.valid[i];
  }
  if (state.unfitted == 0 && (loop == 0 || 2 * known > loop)) return true;
  stop(PatchStatus::stalled, say("the surface around the hole has too few vertices to tell its curvature"));
  return false;
}

bool EvolvingPatch::stop_if(const CancelToken& cancel) {
  if (!cancel.cancelled()) return false;
  stop(PatchStatus::cancelled, say("cancelled"));
  return true;
}

void EvolvingPatch::stop(PatchStatus why, Message text) {
  status = why;
  message = std::move(text);
}

double EvolvingPatch::edge_length() const {
  return mean_edge_length(state.patch.positions, state.patch.triangles, state.patch.patch_triangles);
}

}  // namespace loopmend
