// SPDX-License-Identifier: GPL-3.0-or-later
// The mirror image as a candidate (docs/math/mirror_image.md, "The test").
#pragma once

#include "pipeline/attempt.h"

namespace loopmend {

/// The mirror image in one of the problem's planes, validated and judged. What a person would see of any other patch as a fault of its
/// shape, a bubble or a height, is none here: such is the other side.
/// @returns with status `faired` where it is to be kept, else `failed`, and `mirror` says why not.
PatchResult mirrored_patch(const PatchProblem& problem, const EvolutionOptions& options, const CancelToken& cancel);

/// Bounds by the misfit of the image, in diameters (docs/math/mirror_image.md, "How far off").
ExpectedDeviation expected_mirror_deviation(double misfit);

/// The same for the patch, mesh units.
DeviationEstimate expected_mirror_deviation(const PatchResult& result);

}  // namespace loopmend
