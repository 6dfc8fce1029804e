// SPDX-License-Identifier: GPL-3.0-or-later
// How large a patch will be, and what solving it will take, before either is begun.
#pragma once

#include "mesh/boundary_loops.h"

namespace loopmend {

/// About how many new vertices close the loop: the area of its projection in equilateral triangles of the mean edge around
/// it. Where edge lengths differ along the loop the patch has fewer, about half as many; where it bulges, more.
/// @param density  as InitialPatchOptions has it.
double expected_new_vertices(const SurfaceModel& model, const BoundaryLoop& loop, double density);

/// Megabytes that solving takes at its peak, from what is expected before there is a patch, and from the free vertices of
/// one. Measured: 9.4 kB an expected and 19.8 kB a free vertex at most, on 200 to 166 000 free vertices of exact and split
/// neighborhood.
double expected_memory_mb(double expected_vertices);
double memory_mb_of(int free_vertices);

}  // namespace loopmend
