// SPDX-License-Identifier: GPL-3.0-or-later
// What all attempts at one patch share, and one run of a flow within them.
#pragma once

#include "pipeline/patch_result.h"
#include "pipeline/validate.h"
#include "rim/rim_survey.h"

#include <optional>
#include <vector>

namespace loopmend {

/// The initial patch of a hole, or a bridge between loops, and where it lies.
struct PatchProblem {
  const ScanIndex& scan;
  const Patch& initial;
  /// That make_initial_patch() made it for; empty where it is no such patch: attempts have no other start then.
  const std::vector<BoundaryLoop>& loops;
  const RimSurvey* survey = nullptr;  ///< of the initial patch's neighborhood, where it is known already
};

/// The boundary data that the flow meets in place of the scan's.
struct BoundaryData {
  double noise_share = 0;                  ///< of the white noise that is taken off
  const CalmSurroundings* calm = nullptr;  ///< the neighborhood without its outliers; null: as it is
};

struct AttemptContext {
  const PatchProblem& problem;
  BoundaryData boundary;
  const Evolution::OnStep& on_step;
  const CancelToken& cancel;
};

/// One run of the flow. @returns true if its result may be kept: if it is no worse than the initial patch. Where not, its
/// message says why.
bool run_once(const AttemptContext& context, const Patch& start, const EvolutionOptions& options, PatchResult& result);

/// What is said of a patch that was made without the outliers; empty where there are none.
std::string message_on_outliers(const BoundaryData& boundary);

}  // namespace loopmend
