// SPDX-License-Identifier: GPL-3.0-or-later
// The outlines of two surfaces that lie on each other at a distance, as the sides of a plate: the straight wall between them.
#pragma once

#include "filling/bridge_topology.h"
#include "mesh/boundary_loops.h"

namespace loopmend {

/// Whether the loops run side by side, and each surface ends as the other one does, square to the way between them, along nine tenths
/// of both loops or more. Ends of tubes are left out.
bool are_sides_of_a_plate(const BridgeEnd& a, const BridgeEnd& b);

bool are_outlines_of_a_plate(const BoundaryLoop& a, const BoundaryLoop& b, const BridgeEnd& end_a,
                             const BridgeEnd& end_b);

/// Whether the loops are outlines of a plate's sides, or the rims of a bore through a plate.
bool have_a_wall_between(const BoundaryLoop& a, const BoundaryLoop& b, const BridgeEnd& end_a, const BridgeEnd& end_b);

/// Straight cross edges between the loops, in rows. Empty where there is no strip between them.
/// @param step  length of a row, > 0
SweptBridge bridge_by_wall(const BridgeEnd& a, const BridgeEnd& b, double step);

}  // namespace loopmend
