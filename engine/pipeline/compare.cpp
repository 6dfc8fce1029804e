// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/compare.h"

#include "neighborhood/boundary_fits.h"
#include "operators/curvature_energy.h"
#include "operators/operator_set.h"
#include "pipeline/evolve_patch.h"

#include <algorithm>
#include <cmath>

namespace loopmend {

namespace {

constexpr double mcf_sigma = 0.1;
constexpr int mcf_steps = 40;

/// Far enough to see both sides of the seam: half the diameter of the first loop.
double profile_reach(const Patch& patch) {
  double diameter = 0;
  for (int v : patch.loops.front())
    for (int w : patch.loops.front()) diameter = std::max(diameter, (patch.positions[v] - patch.positions[w]).norm());
  return 0.6 * diameter * patch.scale;
}

int widest_jump(const std::vector<ComparedFlow>& runs) {
  std::vector<double> sum(runs.front().outcome.patch.loops.front().size(), 0);
  for (const ComparedFlow& run : runs) {
    if (run.outcome.flow == FlowKind::mcf) continue;  // its jump is everywhere
    const std::vector<double> jumps = seam_jumps(run.outcome.patch, 0);
    for (std::size_t i = 0; i < sum.size(); ++i)
      if (std::isfinite(jumps[i])) sum[i] += jumps[i];
  }
  return static_cast<int>(std::max_element(sum.begin(), sum.end()) - sum.begin());
}

}  // namespace

PatchEnergies patch_energies(const Patch& patch) {
  const Topology topology(patch.vertex_count(), patch.triangles);
  std::vector<char> wanted(patch.vertex_count());
  for (int i = 0; i < patch.vertex_count(); ++i) wanted[i] = patch.ring[i] <= 4;
  const OperatorSet ops = compute_operators(patch.positions, patch.triangles, topology, Stencil::two_ring, wanted);
  PatchEnergies energies;
  energies.area = patch_area(patch) * patch.scale * patch.scale;
  energies.bending = energy_value(patch, ops, {0, 1});
  energies.variation = energy_value(patch, ops, {1, 0}) / (patch.scale * patch.scale);
  return energies;
}

EvolutionOptions options_for(FlowKind flow, const EvolutionOptions& base) {
  EvolutionOptions options = base;
  options.flow = flow;
  if (options.boundary == BoundaryTrust::automatic) options.boundary = BoundaryTrust::exact;
  if (flow != FlowKind::mcf || base.mode == EvolutionMode::steps) return options;
  options.mode = EvolutionMode::steps;
  options.sigma = mcf_sigma;
  options.max_steps = std::min(base.max_steps, mcf_steps);
  return options;
}

ComparedFlow run_compared(const Patch& start, FlowKind flow, const EvolutionOptions& base,
                          const Evolution::OnStep& on_step, const CancelToken& cancel) {
  ComparedFlow run;
  run.outcome = run_flow(start, options_for(flow, base), on_step, cancel);
  run.energies = patch_energies(run.outcome.patch);
  run.outcome.seams = seam_reports(run.outcome.patch);
  run.wide_jump = wide_curvature_jump(run.outcome.patch);
  return run;
}

std::vector<ProfilePoint> profile_across(const Patch& patch, int edge, std::span<const float> H_sigma) {
  return seam_profile(patch, 0, edge, profile_reach(patch), H_sigma);
}

void describe_start(const Patch& start, FlowComparison& comparison) {
  comparison.start = patch_energies(start);
  comparison.start_seams = seam_reports(start);
  comparison.start_wide_jump = wide_curvature_jump(start);
  comparison.start_validity = patch_validity(start);
}

void add_profiles(FlowComparison& comparison) {
  if (comparison.runs.empty() || comparison.runs.front().outcome.patch.loops.empty()) return;
  comparison.profile_edge = widest_jump(comparison.runs);
  comparison.profiles.clear();
  // The same neighborhood for all, whose fixed vertices keep their order.
  const std::vector<float> H_sigma = curvature_uncertainty(comparison.runs.front().outcome.patch);
  for (const ComparedFlow& run : comparison.runs)
    comparison.profiles.push_back(profile_across(run.outcome.patch, comparison.profile_edge, H_sigma));
}

FlowComparison compare_flows(const Patch& start, const EvolutionOptions& base,
                             const std::function<void(FlowKind)>& progress, const CancelToken& cancel) {
  FlowComparison comparison;
  describe_start(start, comparison);
  for (FlowKind flow : {FlowKind::mcf, FlowKind::sdf, FlowKind::wf, FlowKind::mmcvf}) {
    if (cancel.cancelled()) return comparison;
    if (progress) progress(flow);
    comparison.runs.push_back(run_compared(start, flow, base, nullptr, cancel));
  }
  add_profiles(comparison);
  return comparison;
}

}  // namespace loopmend
