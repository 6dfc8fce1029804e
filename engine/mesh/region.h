// SPDX-License-Identifier: GPL-3.0-or-later
// A region of a surface as a patch: its vertices free, its neighborhood fixed (paper §5, Fig. 5.6).
#pragma once

#include "mesh/patch.h"
#include "mesh/surface_model.h"

#include <vector>

namespace loopmend {

struct Region {
  Patch patch;  ///< its loops are the region's boundaries; every triangle with a free corner is its own
  std::vector<int> free_vertex;   ///< #free: soup point of each free vertex
  std::vector<int> own_triangle;  ///< #patch_triangles: soup triangle of each
  int held_at_boundary = 0;       ///< vertices of the region on the surface's own boundary: they stay
};

/// @param vertices  soup points to be freed, in any order; points outside the view (without a usable face) are left out.
/// @throws InvalidArgument for a number that is no point, a region without a vertex that could move, and one that takes
/// in a whole piece of the surface, so that nothing holds it.
Region make_region(const SurfaceModel& model, const std::vector<int>& vertices);

/// The model's soup with the region as it has evolved. While its triangles are as many as they were, points and triangles keep
/// their numbers, and all but the region's are bit-identical; where it had to be remeshed, its new points come last.
TriangleSoup with_region(const SurfaceModel& model, const Region& region, const Patch& evolved);

}  // namespace loopmend
