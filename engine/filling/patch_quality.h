// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a patch's shape, in numbers.
#pragma once

#include "filling/loop_filler.h"
#include "mesh/patch.h"

namespace loopmend {

/// Folds of the patch and its rim, cuts of the patch with itself and the rings around it, and its smallest angle.
FillerQuality patch_quality(const Patch& patch);

}  // namespace loopmend
