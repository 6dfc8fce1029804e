// SPDX-License-Identifier: GPL-3.0-or-later
// Joining loops by one fair patch from end to end: bridge, candidates, validation, paste.
#pragma once

#include "filling/bridge_loops.h"
#include "pipeline/solve_group.h"

namespace loopmend {

struct BlendResult {
  PatchResult outcome;           ///< failed: the loops were not joined, and the patch is empty
  std::size_t turned_faces = 0;  ///< of parts whose inside faced the gap
  std::optional<Bridge> bridge;  ///< the shapes before the flow
};

/// Joins the loops and pastes the patch. Pieces of surface that face the gap with their inside are turned round first,
/// the piece of the first loop being right. When the result is `failed` or cancelled, the model is as it was.
/// @param on_step  every accepted step; may be empty.
/// @throws InvalidArgument as bridge_loops, and where pieces cannot be made to agree.
BlendResult blend_loops(SurfaceModel& model, const std::vector<BoundaryLoop>& loops, const GroupOptions& options,
                        const CancelToken& cancel, const Evolution::OnStep& on_step = nullptr);

/// The part of blend_loops() between bridge and paste. @param scan  the pieces of which agree.
PatchResult solve_bridge(const ScanIndex& scan, const Bridge& bridge, const std::optional<EvolutionOptions>& options,
                         const Evolution::OnStep& on_step, const CancelToken& cancel);

}  // namespace loopmend
