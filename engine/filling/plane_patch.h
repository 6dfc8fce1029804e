// SPDX-License-Identifier: GPL-3.0-or-later
// A patch of a plane within a closed curve.
#pragma once

#include "filling/loop_patch.h"

namespace loopmend {

/// @param outline  in a plane, seen counter-clockwise against `normal` (unit), as many points as the patch has first
/// @returns nothing where the outline crosses itself, or when cancelled.
std::optional<LoopPatch> plane_patch(const Points& outline, const Vec3& normal, const InitialPatchOptions& options,
                                     const CancelToken& cancel);

}  // namespace loopmend
