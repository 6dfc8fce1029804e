// SPDX-License-Identifier: GPL-3.0-or-later
// A patch joins a surface that has colours.
#pragma once

#include "mesh/surface_model.h"

namespace loopmend {

/// append_patch(). Where the surface has vertex colours, those of the patch's new vertices continue the colours along its boundary
/// harmonically (cotan Laplace equation on the patch, weights clamped), channel by channel, so that they stay within the range of the
/// boundary's. Where that equation cannot be solved, they are the mean of the boundary's.
/// @throws InvalidArgument as append_patch() does; the model is then unchanged.
void append_colored_patch(SurfaceModel& model, const PatchGeometry& patch);

}  // namespace loopmend
