// SPDX-License-Identifier: GPL-3.0-or-later
// Relief of the scan on a finished patch, where a person asked for it.
#pragma once

#include "pipeline/attempt.h"

namespace loopmend {

/// Adds relief to the patch of a hole, its validity and seams measured again, and says so in its message; or says why the patch
/// stays smooth: there is no relief, it cannot be separated from shape, or the patch would fold or cut the surface with it.
/// @param estimate  of the patch's neighborhood
void add_relief(const PatchProblem& problem, const SplitEstimate& estimate, const ReliefChoice& choice,
                const CancelToken& cancel, PatchResult& result);

}  // namespace loopmend
