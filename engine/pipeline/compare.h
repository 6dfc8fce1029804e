// SPDX-License-Identifier: GPL-3.0-or-later
// The four flows from one start (paper Fig. 5.5, 5.6). What `loopmend compare` calls.
#pragma once

#include "analysis/seam_profile.h"
#include "mesh/validity.h"
#include "pipeline/patch_result.h"

#include <functional>
#include <span>
#include <vector>

namespace loopmend {

/// Of one shape, mesh units.
struct PatchEnergies {
  double area = 0;       ///< length²
  double bending = 0;    ///< ∫H² dA, no unit
  double variation = 0;  ///< ∫‖∇H‖² dA, 1/length²
};
PatchEnergies patch_energies(const Patch& patch);

/// One flow of a comparison.
struct ComparedFlow {
  PatchResult outcome;  ///< with its seams
  PatchEnergies energies;
  double wide_jump = 0;  ///< wide_curvature_jump of the result, 1/length
};

struct FlowComparison {
  PatchEnergies start;
  std::vector<SeamReport> start_seams;
  double start_wide_jump = 0;  ///< wide_curvature_jump, 1/length
  Validity start_validity;
  std::vector<ComparedFlow> runs;  ///< MCF, SDF, WF, MMCVF
  int profile_edge = 0;            ///< of loop 0: where the jump of H, summed over the flows, is widest
  std::vector<std::vector<ProfilePoint>> profiles;  ///< of each run, across that edge
};

/// The options for one flow. A comparison is of the flows themselves: BoundaryTrust::automatic becomes exact. MCF takes small steps: between tubes it has no steady state, and large steps fail where the
/// surface is strongly curved (docs/math/energy_to_matrix.md, "Starts").
EvolutionOptions options_for(FlowKind flow, const EvolutionOptions& base);

/// One flow of a comparison, from `start` to its end. @param base  its flow does not count.
ComparedFlow run_compared(const Patch& start, FlowKind flow, const EvolutionOptions& base,
                          const Evolution::OnStep& on_step, const CancelToken& cancel);

/// H across one edge of loop 0, as far as a comparison shows it. @param edge  0-based, along the loop.
/// @param H_sigma  as of seam_profile().
std::vector<ProfilePoint> profile_across(const Patch& patch, int edge, std::span<const float> H_sigma = {});

/// Fills in what is known of the start.
void describe_start(const Patch& start, FlowComparison& comparison);

/// Fills in profile_edge and profiles, once all runs are there; nothing for patches without a loop.
void add_profiles(FlowComparison& comparison);

/// Runs the flows one after another, each from `start` itself.
/// @param base      its flow does not count.
/// @param progress  called before each flow.
FlowComparison compare_flows(const Patch& start, const EvolutionOptions& base,
                             const std::function<void(FlowKind)>& progress, const CancelToken& cancel);

}  // namespace loopmend
