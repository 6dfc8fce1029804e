// SPDX-License-Identifier: GPL-3.0-or-later
// Attempts where the boundary data are rough: robust fairing, what lies between that and the flow, local rollback.
#pragma once

#include "pipeline/attempt.h"

namespace loopmend {

/// What the neighborhood is worth to the sixth order.
struct JudgedNeighborhood {
  RimRoughness roughness;
  std::optional<CalmSurroundings> calm;  ///< where single vertices stand off a neighborhood that is smooth without them
};

/// Empty where the options leave nothing to be judged.
std::optional<JudgedNeighborhood> judge_neighborhood(const PatchProblem& problem, const EvolutionOptions& options);

/// Robust fairing, or the interpolation between that and the flow, as the share that the neighborhood asks for.
/// @returns false if no result may be kept.
bool run_robustly(const AttemptContext& context, const Patch& start, const EvolutionOptions& options,
                  const RimRoughness& roughness, PatchResult& result);

/// Robust fairing that goes back to its start at the places where it would fold or intersect, and there alone.
/// @returns false if no result may be kept.
bool run_with_rollback(const AttemptContext& context, const Patch& start, const EvolutionOptions& options,
                       const RimRoughness& roughness, PatchResult& result);

}  // namespace loopmend
