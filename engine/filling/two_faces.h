// SPDX-License-Identifier: GPL-3.0-or-later
// A hole where two plane faces of a part are missing, which meet at an edge.
#pragma once

#include "filling/loop_patch.h"

#include <optional>

namespace loopmend {

/// Two plane patches that meet at the straight edge between two corners of the loop. Each of the loop's parts between these lies in a
/// plane, to 2e-3 of the loop's diameter (rms; 1e-5 for loops of fewer than 24 edges), and the planes include 15° to 165°. Along four
/// fifths of the loop the surface leaves them by 30° or more, so that both faces are missing as a whole. The loop's points come first.
std::optional<LoopPatch> two_plane_faces(const SurfaceModel& model, const BoundaryLoop& loop,
                                         const InitialPatchOptions& options, const CancelToken& cancel);

}  // namespace loopmend
