// SPDX-License-Identifier: GPL-3.0-or-later
// The flow in a region of a surface, everything else held. What `loopmend evolve` and the window's region tool call.
#pragma once

#include "core/message.h"
#include "mesh/region.h"
#include "pipeline/patch_result.h"

namespace loopmend {

/// @throws InvalidArgument as Evolution.
PatchResult evolve_region(const Region& region, EvolutionOptions options, const Evolution::OnStep& on_step,
                          const CancelToken& cancel);

/// Why the result must not be used: more folds or intersections than the region came with. Empty when it may.
Message refusal_of(const Region& region, const PatchResult& evolved);

/// "2 folded edges and 0 self-intersections"
Message flaws_of(const Validity& validity);

}  // namespace loopmend
