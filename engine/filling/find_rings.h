// SPDX-License-Identifier: GPL-3.0-or-later
// Which loops a ring or a wall joins, as of a pipe, a plate, or a face with holes.
#pragma once

#include "core/cancel.h"
#include "mesh/boundary_loops.h"

#include <vector>

namespace loopmend {

/// Loops that ring_between() joins: outlines with several loops within them, all in one plane, then pairs, the narrowest first, each
/// the nearest wall of the other; indices into `loops`, ascending. No loop is in two of them. Loops that touch others are left out.
std::vector<std::vector<int>> find_rings(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                         const CancelToken& cancel);

/// Those of find_rings() that bound one missing plane face: the outline of each comes first.
std::vector<std::vector<int>> find_missing_faces(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                                 const CancelToken& cancel);

}  // namespace loopmend
