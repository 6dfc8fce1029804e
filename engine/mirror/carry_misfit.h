// SPDX-License-Identifier: GPL-3.0-or-later
// What a mirror image lacks of the surface around a hole, carried in smoothly (docs/math/mirror_image.md, "The misfit").
#pragma once

#include "mirror/mirror_image.h"

namespace loopmend {

/// Moves the image so that it meets the collar: the vectors from the image to the vertices of its collar,
/// interpolated by Σ w_k |p − p_k| + a polynomial of degree 1, the least ∫‖D²u‖² of the kind in space. No more than
/// some 500 vertices count, those on the loop first. Noise of the vectors is left behind. @returns whether there was
/// such a field; without it, and when cancelled, the image is unchanged.
bool carry_misfit(const Patch& patch, const CancelToken& cancel, MirrorImage& image);

}  // namespace loopmend
