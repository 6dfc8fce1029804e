// SPDX-License-Identifier: GPL-3.0-or-later
// How several loops are joined, before any new vertex: triangles over the loops' own vertices.
#pragma once

#include "core/types.h"
#include "mesh/boundary_loops.h"

#include <vector>

namespace loopmend {

/// One loop to be joined to others, in any common frame.
struct BridgeEnd {
  Points points;     ///< in the order of the boundary halfedges, at least 3
  Vec3 axis;         ///< unit: the loop runs counter-clockwise about it
  Vec3 onward;       ///< LoopFacing::onward
  Points conormals;  ///< LoopFacing::conormals
};

/// As the loops' surfaces lie in the model.
std::vector<BridgeEnd> ends_of(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops);

/// +1 if the loop runs counter-clockwise seen along the way the surface goes on, as it does where normals point outwards;
/// −1 if clockwise; 0 if undecided (an island and its hole lie around one centre).
/// @param center  where the loops meet, roughly: the mean of their centres.
int turning_sense(const BridgeEnd& end, const Vec3& center);

/// Two or more loops around a common middle, by the convex hull of circles on a sphere that stand for them
/// (docs/dev/filling.md, "Bridges between loops"). @returns triangles over the loops' vertices, numbered through in the order of `ends`; empty
/// when the loops cannot be seen so.
Triangles bridge_by_hull(const std::vector<BridgeEnd>& ends);

/// The strip between two loops whose cross edges are shortest, squared (dynamic programming): for an island in a loop,
/// and for wavy boundaries. Numbered as in bridge_by_hull; empty when there is none.
Triangles bridge_by_strip(const Points& a, const Points& b);

/// Points and triangles of a bridge that has vertices of its own; the loops' vertices come first.
struct SweptBridge {
  Points points;
  Triangles triangles;
};

enum class SweepShape {
  smooth,   ///< cross edges are cubics that leave both surfaces along their conormals
  straight  ///< cross edges are straight
};

/// An even strip between two loops: smooth, the first shape of an elbow, a U-turn or a long neck.
/// @param step  length of a row along the cross edges, > 0.
SweptBridge bridge_by_sweep(const BridgeEnd& a, const BridgeEnd& b, double step, SweepShape shape = SweepShape::smooth);

}  // namespace loopmend
