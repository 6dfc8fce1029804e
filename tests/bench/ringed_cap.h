// SPDX-License-Identifier: GPL-3.0-or-later
// Patches with an exact number of free vertices, made without any initial patch: rings of vertices on a cap of the unit sphere.
#pragma once

#include "hole_problem.h"
#include "mesh/patch.h"

namespace loopmend::bench {

struct RingedCap {
  HoleProblem problem;  ///< the neighborhood with its one hole; distances are from the sphere
  LoopPatch
      initial_patch;  ///< fits the hole; its free vertices lie on a bump over the sphere, zero with its slope at the boundary
};

/// @param free   vertices of the initial patch, ≥ 7.
/// @param angle  angular radius of the hole, radians, up to 1.5.
/// @param rings  of fixed vertices around, the loop included.
RingedCap make_ringed_cap(int free, double angle, int rings);

}  // namespace loopmend::bench
