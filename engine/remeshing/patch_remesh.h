// SPDX-License-Identifier: GPL-3.0-or-later
// Remeshing the interior of a patch: one round of it, and the way out of a Patch into a ConstrainedRemesher and back.
#pragma once

#include "mesh/patch.h"
#include "remeshing/constrained_remesher.h"

namespace loopmend {

/// Splits, collapses, flips and smooths towards the target sizes.
/// @returns false when another round would change next to nothing.
bool remesh_once(ConstrainedRemesher& mesh);

/// The patch's own triangles, the loops locked, guarded against the neighborhood; target sizes from the boundary and
/// Patch::grading.
ConstrainedRemesher open_for_remeshing(const Patch& patch);

/// The same patch with the interior of `mesh`; fixed vertices and neighborhood are those of `patch`.
Patch with_interior(const Patch& patch, const ConstrainedRemesher& mesh);

}  // namespace loopmend
