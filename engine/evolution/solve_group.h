// SPDX-License-Identifier: GPL-3.0-or-later
// One group of loops from filler to finished patch.
#pragma once

#include "evolution/fill_loops.h"
#include "evolution/patch_verdict.h"

#include <vector>

namespace loopmend {

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
