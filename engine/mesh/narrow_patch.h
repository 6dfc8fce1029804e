// SPDX-License-Identifier: GPL-3.0-or-later
// A patch that carries fewer rings of fixed vertices than a flow needs.
#pragma once

#include "mesh/patch.h"

namespace loopmend {

/// make_patch() with so many rings, at least 1: two are enough to look for folds and to paste it.
Patch make_narrow_patch(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                        const std::vector<LoopPatch>& initial_patches, int rings);

}  // namespace loopmend
