// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/state.h"

#include "core/release.h"
#include "mesh/quality.h"
#include "operators/curvature_energy.h"

#include <algorithm>
#include <utility>

namespace loopmend {

namespace {

double squared_laplacian_of_H(const Patch& patch, const OperatorSet& ops) {
  const Eigen::VectorXd mass = barycentric_areas(patch.positions, patch.triangles);
  double sum = 0;
  for (int i = 0; i < patch.free_count; ++i) {
    const double lap = ops.apply_laplacian(i, ops.H);
    sum += mass[i] * lap * lap;
  }
  return sum;
}

}  // namespace

double measure_of(const Objective& objective, const Patch& patch, const OperatorSet& ops) {
  switch (objective.flow) {
    case FlowKind::mcf: return patch_area(patch);
    case FlowKind::sdf: return squared_laplacian_of_H(patch, ops);
    case FlowKind::wf: return energy_value(patch, ops, {0, 1});
    case FlowKind::mmcvf: return energy_value(patch, ops, {1, objective.bending});
  }
  return 0;
}

namespace {

/// Adds the vertices whose H the ΔH around the free vertices reads: further rings than most where a fit had to be widened.
/// @returns whether there were any.
bool add_read(const OperatorSet& ops, int free_count, std::vector<char>& wanted) {
  std::vector<char> reads_H(wanted.size(), 0);
  for (int e = 0; e < ops.offset[free_count]; ++e) reads_H[ops.index[e]] = 1;
  bool any = false;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    for (int e = ops.offset[i]; reads_H[i] && e < ops.offset[i + 1]; ++e)
      any |= !std::exchange(wanted[ops.index[e]], 1);
  return any;
}

OperatorSet fitted(const Patch& patch, const Topology& topology, const Objective& objective, Stencil stencil, Fits fits,
                   const KnownFits& known = {}) {
  std::vector<char> wanted(patch.vertex_count());
  for (int i = 0; i < patch.vertex_count(); ++i) wanted[i] = patch.ring[i] <= objective.reach;
  const auto compute =
      fits == Fits::operators || objective.flow == FlowKind::sdf ? compute_operators : compute_curvatures;
  OperatorSet ops = compute(patch.positions, patch.triangles, topology, stencil, wanted, known);
  if (objective.reach == flow_reach && !ops.offset.empty() && add_read(ops, patch.free_count, wanted))
    ops = compute(patch.positions, patch.triangles, topology, stencil, wanted, {&ops, 0});
  return ops;
}

EvolutionState state_of(Patch patch, const Objective& objective, Stencil stencil,
                        std::shared_ptr<const Topology> topology, Fits fits, const KnownFits& known) {
  EvolutionState state;
  state.topology = std::move(topology);
  state.ops = fitted(patch, *state.topology, objective, stencil, fits, known);
  state.measure = measure_of(objective, patch, state.ops);
  state.folds = count_folds(patch.positions, patch.triangles, patch.patch_triangles);
  state.unfitted = static_cast<int>(std::count(state.ops.valid.begin(), state.ops.valid.begin() + patch.free_count, 0));
  for (int i = 0; i < patch.vertex_count(); ++i)
    state.missing += patch.ring[i] <= energy_reach && patch.ring[i] <= objective.reach && !state.ops.valid[i];
  state.patch = std::move(patch);
  return state;
}

}  // namespace

EvolutionState make_state(Patch patch, const Objective& objective, Stencil stencil,
                          std::shared_ptr<const Topology> topology, Fits fits) {
  if (!topology) topology = std::make_shared<Topology>(patch.vertex_count(), patch.triangles);
  return state_of(std::move(patch), objective, stencil, std::move(topology), fits, {});
}

void add_weights(EvolutionState& state, const Objective& objective, Stencil stencil) {
  if (state.ops.offset.empty()) state.ops = fitted(state.patch, *state.topology, objective, stencil, Fits::operators);
}

void drop_weights(EvolutionState& state) {
  OperatorSet& ops = state.ops;
  release(ops.offset);
  release(ops.index);
  release(ops.laplacian);
  release(ops.gradient);
  release(ops.gauss);
}

EvolutionState displaced(const EvolutionState& state, const Objective& objective, Stencil stencil,
                         const Eigen::VectorXd& s, Fits fits) {
  Patch patch = state.patch;
  for (int i = 0; i < patch.free_count; ++i) patch.positions[i] += s[i] * state.ops.normal[i];
  const KnownFits known{&state.ops, patch.free_count};
  return state_of(std::move(patch), objective, stencil, state.topology, fits, known);
}

double shown_energy(FlowKind flow, const EvolutionState& state) {
  const double scale = state.patch.scale;
  switch (flow) {
    case FlowKind::mcf:
    case FlowKind::sdf: return patch_area(state.patch) * scale * scale;
    case FlowKind::wf: return state.measure;
    case FlowKind::mmcvf: return energy_value(state.patch, state.ops, {1, 0}) / (scale * scale);
  }
  return 0;
}

}  // namespace loopmend
