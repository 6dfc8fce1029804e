// SPDX-License-Identifier: GPL-3.0-or-later
// One patch from start to steady state, for problems without a hole: points to interpolate, regions of a surface.
#pragma once

#include "pipeline/patch_result.h"

namespace loopmend {

/// Runs the flow from the patch as it is, once. The result's validity is that of the patch and the rings around it.
/// @throws InvalidArgument as Evolution.
PatchResult run_flow(const Patch& start, const EvolutionOptions& options, const Evolution::OnStep& on_step,
                     const CancelToken& cancel);

/// The same from the best of several starts (multi_start.h); where that ends folded, cut or stalled, again from the
/// third-order linear fairing, and the better end is taken.
PatchResult evolve_patch(const Patch& start, const EvolutionOptions& options, const Evolution::OnStep& on_step,
                         const CancelToken& cancel);

}  // namespace loopmend
