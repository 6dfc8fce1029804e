// SPDX-License-Identifier: GPL-3.0-or-later
// The symmetric patch of a hole that lies across a plane of symmetry (docs/math/mirror_image.md, "Across the plane").
#pragma once

#include "mirror/mirror_image.h"

#include <optional>

namespace loopmend {

/// Whether the patch's loop has vertices on both sides of the plane.
bool lies_across(const Patch& patch, const MirrorPlane& plane);

/// The patch moved towards its own mirror image: most where the image is nearer than the patch to the known surface.
/// @param patch with one loop. @param index of the model's soup triangles. @returns none without an image, or when
/// cancelled.
std::optional<Patch> symmetric_patch(const SurfaceModel& model, const TriangleIndex& index, const Patch& patch,
                                     const MirrorPlane& plane, const CancelToken& cancel = {});

}  // namespace loopmend
