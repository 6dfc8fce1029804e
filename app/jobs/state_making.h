// SPDX-License-Identifier: GPL-3.0-or-later
// From an engine's patch to a state that can be shown.
#pragma once

#include "document/patch_state.h"
#include "jobs/scan_context.h"

namespace loopmend {

/// What was done in place of the flow, and why; then what is to be said of the result.
Message message_of(const PatchResult& result);

/// The state of an initial patch.
/// @param scan_colors  as shape_of()
std::shared_ptr<PatchState> first_state(const Patch& patch, const PatchRecipe& recipe, const Vec3& origin,
                                        const std::shared_ptr<const std::vector<Color>>& scan_colors);

/// The state after a run of a flow. @param from  the one before it; it may be of more holes.
std::shared_ptr<PatchState> with_result(const PatchState& from, const PatchResult& result, RunRecipe run,
                                        const Vec3& origin);

/// The state with another patch in it: shape and seam are made again.
std::shared_ptr<PatchState> with_patch(const PatchState& old, const Patch& patch, const Vec3& origin);

/// The state, marked as invalid where its patch is worse than `initial`, or cuts at all where there is none.
PatchStatePtr judged(PatchStatePtr state, const Patch* initial, ScanContext& scan_context);

/// The state with verdicts on its patch, as solve_group() gives them.
/// @param loops  that `initial` was made for; empty where it is a bridge
PatchStatePtr with_verdicts(PatchStatePtr state, const Patch& initial, const std::vector<BoundaryLoop>& loops,
                            const EvolutionOptions& options, ScanContext& scan_context);

}  // namespace loopmend
