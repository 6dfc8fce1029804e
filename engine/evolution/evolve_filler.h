// SPDX-License-Identifier: GPL-3.0-or-later
// From the filler of a hole, or a bridge between loops, to the patch that may be kept.
#pragma once

#include "evolution/evolution.h"
#include "evolution/fill_loops.h"
#include "evolution/patch_verdict.h"
#include "evolution/proportion.h"
#include "rim/rim_survey.h"

#include <string>
#include <vector>

namespace loopmend {

/// What a flow made of a filler.
struct Evolved {
  Patch patch;
  PatchVerdict verdict;           ///< on the patch; empty when cancelled
  std::vector<SeamReport> seams;  ///< of the patch, one for each loop; empty where it is a filler, or when cancelled
  LoopStatus status = LoopStatus::filled;
  std::string message;
  Method method = Method::initial_patch;
  std::string reason;  ///< why it is not the flow that was asked for, and how to get that; empty if it is
  std::vector<Proportion> proportions;  ///< to the filler, one for each loop; empty where it is the filler
  int steps = 0;
  bool faired = false;  ///< set out from a linear fairing
  double bending = 0;
  double assemble = 0, solve = 0, initial_energy = 0, final_energy = 0;
};

/// The flow from the filler. Where the sixth order would spoil the patch, bending energy is blended in; where that does
/// not help either, the filler stays and the message says so. Where the patch comes out of proportion, what bulges less is
/// taken in its place, unless BoundaryTrust::exact asks for the flow itself; if nothing does, the status is `doubtful`.
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

}  // namespace loopmend
