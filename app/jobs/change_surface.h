// SPDX-License-Identifier: GPL-3.0-or-later
// Faces taken away by hand, and loops parted where they pass a vertex twice: the surface, and where its points went.
#pragma once

#include "jobs/carry_patches.h"
#include "mesh/boundary_loops.h"

#include <vector>

namespace loopmend {

struct ChangedSurface {
  TriangleSoup soup;
  NewPoints new_points;
  std::size_t changes = 0;  ///< faces taken away, or vertices parted
};

/// Without every triangle that has one of these points as a corner, and without points that only such triangles used.
/// @throws InvalidArgument where no triangle would be left.
ChangedSurface without_faces_at(const TriangleSoup& soup, const std::vector<int>& points);

/// Boundary loops of the new scan that run along an edge which was inside the old surface. Holes only; ascending.
std::vector<int> loops_opened(const SurfaceModel& before, const OpenedScan& after, const NewPoints& new_points);

/// Whether the loop passes a vertex more than once.
bool touches_itself(const BoundaryLoop& loop);

/// Where one of the loops passes a vertex more than once, the largest fan of faces keeps its point and each other gets one of its own in
/// the same place: what hung there by a vertex alone becomes an island.
ChangedSurface parted_at_touches(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops);

}  // namespace loopmend
