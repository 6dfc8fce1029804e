// SPDX-License-Identifier: GPL-3.0-or-later
// What all attempts at one patch share, and one run of a flow within them.
#pragma once

#include "mirror/mirror_plane.h"
#include "neighborhood/outlier_vertices.h"
#include "pipeline/judge.h"
#include "pipeline/patch_result.h"
#include "pipeline/validate.h"

#include <vector>

namespace loopmend {

/// The initial patch of a hole, or a bridge between loops, and where it lies.
struct PatchProblem {
  const ScanIndex& scan;
  const Patch& initial;
  /// That make_initial_patch() made it for; empty where it is no such patch: attempts have no other start then.
  const std::vector<BoundaryLoop>& loops;
  /// In which the patch may be the mirror image of the other side; null or empty: it may not.
  const std::vector<MirrorPlane>* mirror_planes = nullptr;
  /// Whether attempts may start from other triangles between the loops: not where `initial` was made to cut nothing.
  enum class Triangles { any, of_initial } triangles = Triangles::any;
};

struct AttemptContext {
  const PatchProblem& problem;
  /// The neighborhood without its outliers, which the patch meets all the same; null: as it is.
  const CleanNeighborhood* clean_neighborhood;
  const Judge& judge;
  const Evolution::OnStep& on_step;
  const CancelToken& cancel;
};

/// One run of the flow, validated and judged. A split flow that folds or crosses at a few places reverts locally to its fairings
/// there, if that is better; its message says so. Folds that are left are opened where that is possible (unfold.h). @returns false where there is no patch, with the cause in its message, or
/// when cancelled.
bool run_once(const AttemptContext& context, const Patch& start, const EvolutionOptions& options, PatchResult& result);

/// Of the flow, as reports have it: units as in StepRecord.
double energy_of(const Patch& patch, FlowKind flow);

/// Makes the patch the result's: validated, and judged by `judge`.
void take_patch(const AttemptContext& context, const Judge& judge, FlowKind flow, Patch patch, PatchResult& result);

/// Opens folds of the patch (unfold.h) where it then has fewer faults.
void open_folds(const AttemptContext& context, FlowKind flow, PatchResult& result);

}  // namespace loopmend
