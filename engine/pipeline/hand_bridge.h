// SPDX-License-Identifier: GPL-3.0-or-later
// A bridge that a person asks for: a strip across a complex hole makes two simpler ones of it.
#pragma once

#include "mesh/surface_model.h"

namespace loopmend {

struct HandBridge {
  TriangleSoup soup;     ///< with the strip; its points and faces come last
  int from = 0, to = 0;  ///< soup points at which it begins and ends
};

/// A strip between two boundary vertices, two triangles wide: it takes the boundary edges on both sides of
/// each. Its middle is a cubic that leaves the surface tangentially towards the other end; the surface's tangent planes at the ends
/// are means over a few boundary edges, so that a ragged boundary does not twist the strip. Where a tooth of the boundary stands
/// before it, an end moves aside by one or two boundary edges.
/// @param a, b  soup points on boundary loops. On one loop, the strip parts it into two; on two, it makes one of them.
/// @throws InvalidArgument where a point is on no boundary, or both ends have a vertex of their edges in common.
HandBridge with_bridge(const SurfaceModel& model, int a, int b);

}  // namespace loopmend
