// SPDX-License-Identifier: GPL-3.0-or-later
// Where a boundary loop lies, which way it turns, and which way the surface would go on beyond it.
#pragma once

#include "mesh/boundary_loops.h"

namespace loopmend {

struct LoopFacing {
  Vec3 center;    ///< mean of the loop's vertices, mesh units
  double radius;  ///< mean distance from the centre, mesh units
  Vec3 axis;      ///< unit: the loop runs counter-clockwise about it; zero for a loop that encloses no area
  Points
      edge_conormals;  ///< at each edge to the next vertex: unit, tangent to its face, square to it, out of the surface
  Points conormals;    ///< at each vertex of the loop: unit, mean of its edges'
  Vec3 onward;         ///< mean conormal: norm 1 at the end of a tube, 0 at a hole in a plane
};

LoopFacing loop_facing(const SurfaceModel& model, const BoundaryLoop& loop);

}  // namespace loopmend
