// SPDX-License-Identifier: GPL-3.0-or-later
// A bridge that a person asks for: a strip across a complex hole makes two simpler ones of it.
#pragma once

#include "mesh/surface_model.h"

namespace loopmend {

/// The model's soup with a strip between the boundary edges that begin at two boundary vertices. It leaves the surface on both
/// sides along its tangent plane, and its rows are as long as these edges. New points and faces come last.
/// @param a, b  soup points on boundary loops. On one loop, the strip parts it into two; on two, it makes one of them.
/// @throws InvalidArgument where a point is on no boundary, or the two edges have a vertex in common.
TriangleSoup with_bridge(const SurfaceModel& model, int a, int b);

}  // namespace loopmend
