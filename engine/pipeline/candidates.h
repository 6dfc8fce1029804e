// SPDX-License-Identifier: GPL-3.0-or-later
// From an initial patch to the patch that a person gets: candidates in order, each judged, the first sound one kept.
#pragma once

#include "pipeline/attempt.h"

namespace loopmend {

/// The first candidate without a hard fault (pipeline/judge.h), in the order of the table in candidates.cpp: what was asked for,
/// then robust fairing, tangent fairing, the minimal surface. Where all have one, the candidate with the least; the initial
/// patch, with status `filled`, where it has less than all of them.
/// @param options  its split, where given, is that of the initial patch.
/// @param on_step  every accepted step, also of candidates that are dropped later; may be empty.
/// @returns status `cancelled` when cancelled; never `failed`: a caller who cannot use an invalid patch looks at validity.
PatchResult solve_patch(const PatchProblem& problem, const EvolutionOptions& options, const Evolution::OnStep& on_step,
                        const CancelToken& cancel);

/// The initial patch as a result: validated and judged, no flow.
PatchResult initial_result(const PatchProblem& problem, FlowKind flow);

/// Judges the patch of the result again, after it was changed.
void judge_again(const PatchProblem& problem, const EvolutionOptions& options, PatchResult& result);

/// Tells how far the patch is likely from what was there, and adds to its verdicts where that is far. Does nothing for patches of a
/// kind that the error bar was not calibrated on: other flows, options of the flow that a person chose, caps over a cut.
void expect_deviation(const EvolutionOptions& options, const CancelToken& cancel, PatchResult& result);

}  // namespace loopmend
