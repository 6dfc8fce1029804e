// SPDX-License-Identifier: GPL-3.0-or-later
// Holes that a saw made: the boundary lies in one plane, and the surface runs through it without bending towards closing.
#pragma once

#include "mesh/boundary_loops.h"

namespace loopmend {

/// Whether what is missing is a flat cap, as at the base of a bust or the end of a tube, and not a dome: the loop is plane, the
/// surface meets the plane steeply, and it bends inward there much less than a ball through the loop would, or much more.
bool is_flat_cut(const SurfaceModel& model, const BoundaryLoop& loop);

/// How far from the loop is_flat_cut looks, as the crow flies; 0 where the loop itself tells.
double reach_of_flat_cut(const SurfaceModel& model, const BoundaryLoop& loop);

}  // namespace loopmend
