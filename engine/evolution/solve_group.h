// One group of loops from filler to finished patch.
#pragma once

#include "evolution/fill_loops.h"
#include "evolution/patch_verdict.h"
#include "rim/rim_survey.h"

#include <vector>

namespace loopmend {

/// What a flow made of a filler.
struct Evolved {
  Patch patch;
  PatchVerdict verdict;           ///< on the patch; empty when cancelled
  std::vector<SeamReport> seams;  ///< of the patch, one for each loop; empty where it is a filler, or when cancelled
  LoopStatus status = LoopStatus::filled;
  std::string message;
  int steps = 0;
  bool faired = false;  ///< set out from a linear fairing
  double bending = 0;
  double assemble = 0, solve = 0, initial_energy = 0, final_energy = 0;
};

/// The flow from the filler. Where the sixth order would spoil the patch, bending energy is blended in; where that does
/// not help either, the filler stays and the message says so.
///
/// On rough surroundings, where a few linear fairings are the whole way, what they set out from matters: each takes the
/// metric of the shape before it, and of all shapes the filler, a minimal surface, has the least area. There the first
/// start is the triangulation of the loops before it was relaxed (FillerShape::triangulated), the filler the second.
/// @param loops      that start_patch made the filler for; empty where it is no such filler: it is the only start then.
/// @param asked_for  its roughness, where given, is that of the filler.
/// @param survey     of the filler's surroundings, where it is known already; else null.
/// @param on_step    every accepted step, also of runs that are thrown away later; may be empty.
Evolved evolve_filler(const FillSite& site, const Patch& filler, const std::vector<BoundaryLoop>& loops,
                      const EvolutionOptions& asked_for, const Evolution::OnStep& on_step, const CancelToken& cancel,
                      const RimSurvey* survey = nullptr);

/// A finished patch, and which of the group's loops it closes.
struct FinishedPatch {
  PatchGeometry geometry;
  std::vector<int> loops;  ///< indices into GroupOutcome::results
};

struct GroupOutcome {
  std::vector<FinishedPatch> patches;  ///< to be pasted, in order
  std::vector<LoopResult> results;     ///< in the order of the group
};

/// Solves the loops jointly; where that leaves one of them cut, folded or open, each by itself. Never throws: what goes
/// wrong is told in the results.
GroupOutcome solve_group(const FillSite& site, const std::vector<BoundaryLoop>& group, const FillOptions& options,
                         const CancelToken& cancel);

/// Results that say that all loops of the group were left open.
GroupOutcome failed_group(const std::vector<BoundaryLoop>& group, const std::string& why);

}  // namespace loopmend
