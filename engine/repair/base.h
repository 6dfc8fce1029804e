// SPDX-License-Identifier: GPL-3.0-or-later
// A base under an open surface, as prints of a face, a bust or a jaw need it.
#pragma once

#include "mesh/boundary_loops.h"

namespace loopmend {

/// The soup with a straight wall from the loop to a plane below it, which closes it. Below is behind the surface, square to the loop's
/// plane. The wall's rows are about as high as the loop's edges are long. New points and faces come last.
/// @param distance  of the plane from the lowest vertex of the connected surface, above 0, mesh units
/// @throws InvalidArgument for a distance out of range, where the loop encloses no area, where it overlaps itself seen from below, and
/// where the wall or the plane would cut the surface.
TriangleSoup with_base(const SurfaceModel& model, const BoundaryLoop& loop, double distance);

}  // namespace loopmend
