// SPDX-License-Identifier: GPL-3.0-or-later
// Keeping the triangles of an evolving patch good: normal motion alone squeezes them.
#pragma once

#include "evolution/state.h"

namespace loopmend {

/// Slides every free vertex half the way to the centroid of its one-ring, within its fitted quadratic, so that the
/// surface keeps its shape to second order (docs/math/energy_to_matrix.md, "Gauss-Newton step"). At most a quarter of the shortest
/// edge.
Patch tangentially_relaxed(const EvolutionState& state);

/// Guarded Delaunay flips inside the patch.
Patch with_delaunay_flips(const Patch& patch);

/// Splits, collapses, flips, smoothing and untangling under guard. The patch as it was, where no free vertex would be left.
Patch remeshed(const Patch& patch);

}  // namespace loopmend
