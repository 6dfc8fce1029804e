// SPDX-License-Identifier: GPL-3.0-or-later
// Remeshing the interior of a patch: one round of it, and the way out of a Patch into a GuardedMesh and back.
#pragma once

#include "filling/guarded_mesh.h"
#include "mesh/patch.h"

namespace loopmend {

/// Splits, collapses, flips and smooths towards the target sizes.
/// @returns false when another round would change next to nothing.
bool remesh_once(GuardedMesh& mesh);

/// The patch's own triangles, the loops locked, guarded against the surroundings; target sizes from the rim and
/// Patch::grading.
GuardedMesh open_for_remeshing(const Patch& patch);

/// The same patch with the interior of `mesh`; fixed vertices and surroundings are those of `patch`.
Patch with_interior(const Patch& patch, const GuardedMesh& mesh);

}  // namespace loopmend
