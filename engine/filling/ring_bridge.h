// SPDX-License-Identifier: GPL-3.0-or-later
// Loops at which a wall ends, as of a pipe, a hollow print or a block with bores: the flat or conical ring between them.
#pragma once

#include "filling/bridge_topology.h"

#include "mesh/boundary_loops.h"

#include <optional>
#include <vector>

namespace loopmend {

/// Whether all surfaces meet a common plane steeply along nine tenths of the loops or more, and one loop is the outline in it: all
/// others lie within that, none within another. They come from the same side, or lie_in_one_plane(): a boss on a plate, the shoulder of
/// a shaft.
/// @param ends  at least two @returns the outline's index; empty where they are no such walls
std::optional<std::size_t> outline_of_a_ring(const std::vector<BridgeEnd>& ends);

/// Whether these loops lie in one plane but for noise, as those around a missing face do.
bool lie_in_one_plane(const std::vector<BridgeEnd>& ends);

/// Whether both surfaces bend towards each other before they end, as the halves of a torus do: a half circle through both loops has
/// that curvature. Then they run on, and a ring would cut them off.
/// @param loops  two, whose ends are walls of a ring
bool bend_towards_each_other(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                             const std::vector<BridgeEnd>& ends);

/// The first shapes of the ring, the better one first: a constrained Delaunay triangulation seen along the walls, which is flat where
/// the loops lie in one plane, and between two also straight rows, which are conical where these are parallel circles.
/// @param ends  walls of a ring. @param step  length of a row, > 0
std::vector<SweptBridge> bridges_by_ring(const std::vector<BridgeEnd>& ends, double step);

}  // namespace loopmend
