// SPDX-License-Identifier: GPL-3.0-or-later
// A plane base under an upright wall that ends in teeth.
#pragma once

#include "filling/loop_patch.h"

namespace loopmend {

/// A patch that runs the wall straight on to a plane below its lowest tooth, half a boundary edge or 2 % of the loop's diameter, whichever is less, and
/// closes it there. The plane is that of the loop.
/// @param options  density of the base
/// @returns nothing where the loop encloses no area, where it overlaps itself seen from below, or when cancelled.
std::optional<LoopPatch> straight_base(const SurfaceModel& model, const BoundaryLoop& loop,
                                       const InitialPatchOptions& options, const CancelToken& cancel);

}  // namespace loopmend
