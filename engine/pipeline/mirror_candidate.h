// SPDX-License-Identifier: GPL-3.0-or-later
// The mirror image as a candidate (docs/math/mirror_image.md, "The test").
#pragma once

#include "pipeline/attempt.h"

namespace loopmend {

/// The mirror image in one of the problem's planes, validated and judged. What a person would see of any other patch as a fault of its
/// shape, a bubble or a height, is none here: such is the other side.
/// @returns with status `faired` where it fits, else `failed`, and `mirror` says why not.
PatchResult mirrored_patch(const PatchProblem& problem, const EvolutionOptions& options, const CancelToken& cancel);

/// Whether the image is to be kept in place of the ordinary patch: where it differs from it, or that is bad or likely
/// farther off. @param copy that fits; its `mirror` gets the answer.
bool is_copied(const PatchResult& ordinary, const CancelToken& cancel, PatchResult& copy);

/// Makes the patch of a hole that lies across a plane of symmetry symmetric (`result.mirror`), unless it has more
/// faults then, or is likely nearer to what was there than the surface around is to its image.
/// @param judge  of the patch.
void make_symmetric(const PatchProblem& problem, const Judge& judge, const CancelToken& cancel, PatchResult& result);

/// Bounds of a copy, in diameters (docs/math/mirror_image.md, "How far off"). @param difference from the ordinary
/// patch, diameters.
/// @param seam_deg  rms bend at the copy's seam. @param misfit  MirrorFit::misfit: the likely bound is no smaller.
ExpectedDeviation expected_mirror_deviation(double difference, double seam_deg, double misfit);

/// The same for the patch, mesh units.
DeviationEstimate expected_mirror_deviation(const PatchResult& result);

}  // namespace loopmend
