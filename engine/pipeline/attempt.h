// SPDX-License-Identifier: GPL-3.0-or-later
// What all attempts at one patch share, and one run of a flow within them.
#pragma once

#include "neighborhood/outlier_vertices.h"
#include "pipeline/patch_result.h"
#include "pipeline/validate.h"

#include <optional>
#include <vector>

namespace loopmend {

/// The initial patch of a hole, or a bridge between loops, and where it lies.
struct PatchProblem {
  const ScanIndex& scan;
  const Patch& initial;
  /// That make_initial_patch() made it for; empty where it is no such patch: attempts have no other start then.
  const std::vector<BoundaryLoop>& loops;
};

struct AttemptContext {
  const PatchProblem& problem;
  /// The neighborhood without its outliers, which the patch meets all the same; null: as it is.
  const CleanNeighborhood* clean_neighborhood;
  const Evolution::OnStep& on_step;
  const CancelToken& cancel;
};

/// One run of the flow. The split form of MMCVF, where it would fold or intersect at a few places, goes back to its fairings
/// there, and its message says so. @returns true if its result may be kept: if it is no worse than the initial patch. Where not, its
/// message says why.
bool run_once(const AttemptContext& context, const Patch& start, const EvolutionOptions& options, PatchResult& result);

/// The same, but where the result would fold or intersect, it goes back to `start` at these places and there alone.
bool run_with_rollback(const AttemptContext& context, const Patch& start, const EvolutionOptions& options,
                       PatchResult& result);

}  // namespace loopmend
