// SPDX-License-Identifier: GPL-3.0-or-later
// What is tried, and in which order, to turn an initial patch into the patch that a person gets.
#pragma once

#include "pipeline/attempt.h"

namespace loopmend {

/// The first attempt of the table in strategy.cpp whose result may be kept; the initial patch, with status `filled`, where
/// none may. Where the patch comes out of proportion to its loops, what bulges less is taken in its place, unless
/// BoundaryTrust::exact asks for the flow itself; if nothing does, the status is `doubtful`.
/// @param options  its split, where given, is that of the initial patch.
/// @param on_step  every accepted step, also of attempts that are thrown away later; may be empty.
/// @returns status `cancelled` when cancelled; never `failed`: a caller who cannot use an invalid patch looks at validity.
PatchResult solve_patch(const PatchProblem& problem, const EvolutionOptions& options, const Evolution::OnStep& on_step,
                        const CancelToken& cancel);

/// The initial patch as a result: validated, no flow.
PatchResult initial_result(const PatchProblem& problem, FlowKind flow);

}  // namespace loopmend
