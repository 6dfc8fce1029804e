// SPDX-License-Identifier: GPL-3.0-or-later
// What a mirror image lacks of the surface around a hole, carried in smoothly (docs/math/mirror_image.md, "The misfit").
#pragma once

#include "mirror/mirror_image.h"

namespace loopmend {

/// Moves the image so that it meets the collar: the vectors from the image to the vertices of its collar, interpolated by
/// Σ w_k |p − p_k| + a polynomial of degree 1, the least ∫‖D²u‖² of the kind in space. No more than some 500 vertices count, those on the loop first.
/// @returns whether the vectors could be interpolated; the image is then unchanged otherwise, and when cancelled.
bool carry_misfit(const Patch& patch, const CancelToken& cancel, MirrorImage& image);

}  // namespace loopmend
