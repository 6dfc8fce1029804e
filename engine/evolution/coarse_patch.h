// SPDX-License-Identifier: GPL-3.0-or-later
// Coarsens a large patch, and prolongates the solution of the coarse one.
#pragma once

#include "evolution/state.h"

namespace loopmend {

/// True if a coarse copy would have so few vertices that solving on it first pays.
bool worth_coarsening(const Patch& patch);

/// The same shape with triangles that grow inward from the boundary, to a twelfth of the patch's radius.
Patch coarsened(const Patch& patch);

/// The surface of the coarse state with triangles as `grading` wants them. New vertices lie on the quadratic forms of the
/// coarse vertices around them, averaged with weights that fade with the distance.
Patch refined(const EvolutionState& coarse, const Grading& grading);

}  // namespace loopmend
